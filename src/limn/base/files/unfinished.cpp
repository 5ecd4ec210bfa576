#include "limn/base/files/unfinished.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <memory>

namespace limn::base {

/// One of a list that only grows; what is no longer used is used again. `path` is written only
/// while the state is `claimed`, and read by others only while it is `file` or `folder`.
struct Unfinished::Node {
  enum State : int { unused, claimed, file, folder };
  explicit Node(std::size_t size) : capacity(size), path(std::make_unique<char[]>(size)) {}

  std::atomic<int> state{claimed};
  const std::size_t capacity;
  const std::unique_ptr<char[]> path;
  Node* next = nullptr;
};

namespace {

using Node = Unfinished::Node;

std::atomic<Node*> list{nullptr};  // never freed: a signal may come after the end of main
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<Node*>::is_always_lock_free);

/// A node of this thread's own, for a path of `size` bytes.
Node* claim(std::size_t size) {
  for (Node* node = list.load(); node != nullptr; node = node->next) {
    int expected = Node::unused;
    if (node->capacity >= size && node->state.compare_exchange_strong(expected, Node::claimed))
      return node;
  }
  constexpr std::size_t kUsual = 256;
  Node* const node = std::make_unique<Node>(std::max(size, kUsual)).release();
  node->next = list.load();
  while (!list.compare_exchange_weak(node->next, node)) {
  }
  return node;
}

}  // namespace

Unfinished::Unfinished(const std::string& path, Kind kind) : node_(claim(path.size() + 1)) {
  std::memcpy(node_->path.get(), path.c_str(), path.size() + 1);
  node_->state.store(kind == Kind::file ? Node::file : Node::folder);
}

Unfinished::~Unfinished() {
  if (node_ != nullptr) node_->state.store(Node::unused);
}

void remove_unfinished_files() noexcept {
  const int saved = errno;
  for (Node* node = list.load(); node != nullptr; node = node->next)
    if (node->state.load() == Node::file) ::unlink(node->path.get());
  // a folder goes once the folders in it are gone, which may come later in the list
  for (bool again = true; again;) {
    again = false;
    for (Node* node = list.load(); node != nullptr; node = node->next)
      if (node->state.load() == Node::folder) again = ::rmdir(node->path.get()) == 0 || again;
  }
  errno = saved;
}

}  // namespace limn::base
