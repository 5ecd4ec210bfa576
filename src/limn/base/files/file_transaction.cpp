#include "limn/base/files/file_transaction.h"

#include <sys/stat.h>

#include <cassert>
#include <cerrno>
#include <csignal>
#include <filesystem>

#include "limn/base/files/file.h"
#include "limn/base/files/system_file.h"
#include "limn/base/files/transaction_parts.h"

namespace limn::base {
namespace fs = std::filesystem;
namespace {

thread_local FileTransaction::Parts* current_parts = nullptr;

/// Holds the signals of this thread back, but for those that report its own faults.
class SignalsWait {
 public:
  SignalsWait() {
    sigset_t all;
    sigfillset(&all);
    for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) sigdelset(&all, fault);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
  }
  ~SignalsWait() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;

 private:
  sigset_t before_{};
};

/// "a//b/./" as "a/b".
std::string plain(const std::string& path) {
  std::string text = fs::path(path).lexically_normal().string();
  while (text.size() > 1 && text.back() == '/') text.pop_back();
  return text;
}

bool is_inside(const std::string& path, const std::string& folder) {
  return path.size() > folder.size() && path.starts_with(folder) && path[folder.size()] == '/';
}

bool is_folder(const std::string& path) {
  struct stat info {};
  return ::stat(path.c_str(), &info) == 0 && S_ISDIR(info.st_mode);
}

/// The folder itself and those above it, the topmost first.
std::vector<std::string> with_parents(const std::string& path) {
  std::vector<std::string> list;
  fs::path whole;
  for (const fs::path& part : fs::path(path)) {
    whole /= part;
    list.push_back(whole.string());
  }
  return list;
}

}  // namespace

FileTransaction::Parts* FileTransaction::Parts::current() { return current_parts; }

std::string FileTransaction::Parts::present_path(const std::string& path) const {
  if (folders.empty()) return path;
  const std::string normal = plain(path);
  for (const Staged& folder : folders)
    if (normal == folder.target() || is_inside(normal, folder.target()))
      return folder.temporary() + normal.substr(folder.target().size());
  return path;
}

Status FileTransaction::Parts::add(Staged file) {
  for (const Staged& other : files)
    if (is_same_output(other.target(), file.target()))
      return Error{"cannot write: it is the same file as the output " + other.shown(),
                   "give each output a name of its own", file.shown(), 0, 0};
  files.push_back(std::move(file));
  return Done{};
}

Status FileTransaction::Parts::add_folder(const std::string& path) {
  for (const std::string& part : with_parents(plain(path))) {
    const std::string present = present_path(part);
    if (is_folder(present)) continue;
    struct stat info {};
    if (::lstat(present.c_str(), &info) == 0)  // a file, or a link that leads nowhere
      return system_error(part, "cannot make the folder", ENOTDIR);
    if (present == part) {
      Result<Staged> folder = Staged::folder(path, part);
      if (!folder) return folder.error();
      folders.push_back(*std::move(folder));
      continue;
    }
    subfolders.emplace_back(present, Unfinished::Kind::folder);
    if (::mkdir(present.c_str(), 0777) != 0)
      return system_error(part, "cannot make the folder", errno);
  }
  return Done{};
}

FileTransaction::FileTransaction() : parts_(std::make_unique<Parts>()) {
  assert(current_parts == nullptr);
  current_parts = parts_.get();
}

FileTransaction::~FileTransaction() { current_parts = nullptr; }

Status FileTransaction::commit() {
  const SignalsWait wait;
  std::vector<Staged*> done;
  const auto put = [&](std::vector<Staged>& list) -> Status {
    for (Staged& one : list) {
      done.push_back(&one);
      if (Status status = one.put_in_place(true); !status) return status;
    }
    return Done{};
  };
  // files first: those of new folders take their names inside them, which nobody sees yet
  Status status = put(parts_->files);
  if (status) status = put(parts_->folders);
  if (!status)
    for (auto one = done.rbegin(); one != done.rend(); ++one) (*one)->undo();
  parts_->files.clear();
  parts_->subfolders.clear();
  parts_->folders.clear();
  return status;
}

Status make_folder(const std::string& path) {
  if (FileTransaction::Parts* const parts = FileTransaction::Parts::current())
    return parts->add_folder(path);
  std::error_code code;
  fs::create_directories(path, code);
  if (code && !is_folder(path)) return system_error(path, "cannot make the folder", code.value());
  return Done{};
}

}  // namespace limn::base
