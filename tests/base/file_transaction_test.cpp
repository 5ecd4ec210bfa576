#include "limn/base/files/file_transaction.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "limn/base/files/file.h"
#include "support/temporary_folder.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

class FileTransactionTest : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return temporary_ / name; }
  [[nodiscard]] int entries() const {
    return static_cast<int>(std::distance(fs::recursive_directory_iterator(folder_), {}));
  }
  test::TemporaryFolder temporary_;
  const fs::path& folder_ = temporary_.path();
};

TEST_F(FileTransactionTest, NothingIsThereBeforeTheCommitAndAllAfterIt) {
  ASSERT_TRUE(base::write_file(path("old"), "old").ok());
  base::FileTransaction transaction;
  ASSERT_TRUE(base::write_file(path("old"), "new").ok());
  ASSERT_TRUE(base::write_file(path("a"), "1").ok());
  EXPECT_EQ(*base::read_file(path("old")), "old");
  EXPECT_FALSE(fs::exists(path("a")));
  ASSERT_TRUE(transaction.commit().ok());
  EXPECT_EQ(*base::read_file(path("old")), "new");
  EXPECT_EQ(*base::read_file(path("a")), "1");
  EXPECT_EQ(entries(), 2);
}

TEST_F(FileTransactionTest, WithoutACommitNothingIsLeft) {
  ASSERT_TRUE(base::write_file(path("old"), "old").ok());
  {
    base::FileTransaction transaction;
    ASSERT_TRUE(base::write_file(path("old"), "new").ok());
    ASSERT_TRUE(base::make_folder(path("x/y/z")).ok());
    ASSERT_TRUE(base::write_file(path("x/y/z/a"), "1").ok());
    ASSERT_TRUE(base::write_file(path("x/b"), "2").ok());
    EXPECT_FALSE(fs::exists(path("x")));
  }
  EXPECT_EQ(*base::read_file(path("old")), "old");
  EXPECT_EQ(entries(), 1);
  ASSERT_TRUE(base::write_file(path("later"), "at once").ok());
  EXPECT_TRUE(fs::exists(path("later")));
}

TEST_F(FileTransactionTest, ARenameThatFailsUndoesTheEarlierOnes) {
  ASSERT_TRUE(base::write_file(path("old"), "old").ok());
  ::chmod(path("old").c_str(), 0640);
  {
    base::FileTransaction transaction;
    ASSERT_TRUE(base::make_folder(path("x")).ok());
    ASSERT_TRUE(base::write_file(path("x/a"), "1").ok());
    ASSERT_TRUE(base::write_file(path("old"), "new").ok());
    ASSERT_TRUE(base::write_file(path("fresh"), "2").ok());
    ASSERT_TRUE(base::write_file(path("blocked"), "3").ok());
    fs::create_directories(path("blocked/inside"));  // nothing can be renamed over it
    const Status status = transaction.commit();
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().file, path("blocked"));
  }
  EXPECT_EQ(*base::read_file(path("old")), "old");
  EXPECT_FALSE(fs::exists(path("fresh")));
  EXPECT_FALSE(fs::exists(path("x")));
  EXPECT_EQ(entries(), 3);  // old, blocked, blocked/inside
}

TEST_F(FileTransactionTest, AFolderIsRenamedAndAnOldOneKeepsItsOtherFiles) {
  fs::create_directories(path("there"));
  ASSERT_TRUE(base::write_file(path("there/mine"), "mine").ok());
  ASSERT_TRUE(base::write_file(path("there/page"), "old").ok());
  {
    base::FileTransaction transaction;
    ASSERT_TRUE(base::make_folder(path("there/")).ok());
    ASSERT_TRUE(base::make_folder(path("there//deeper/still")).ok());
    ASSERT_TRUE(base::write_file(path("there/page"), "new").ok());
    ASSERT_TRUE(base::write_file(path("there/deeper/still/page"), "1").ok());
    ASSERT_TRUE(base::make_folder(path("new/./folder")).ok());
    ASSERT_TRUE(base::write_file(path("new/folder/page"), "2").ok());
    ASSERT_TRUE(transaction.commit().ok());
  }
  EXPECT_EQ(*base::read_file(path("there/mine")), "mine");
  EXPECT_EQ(*base::read_file(path("there/page")), "new");
  EXPECT_EQ(*base::read_file(path("there/deeper/still/page")), "1");
  EXPECT_EQ(*base::read_file(path("new/folder/page")), "2");
  EXPECT_EQ(entries(), 9);
}

TEST_F(FileTransactionTest, AFolderWhereAFileIsCannotBeMade) {
  ASSERT_TRUE(base::write_file(path("file"), "x").ok());
  EXPECT_FALSE(base::make_folder(path("file/below")).ok());
  base::FileTransaction transaction;
  const Status status = base::make_folder(path("file/below"));
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().file, path("file"));
}

TEST_F(FileTransactionTest, OneFileIsWrittenOnce) {
  fs::create_symlink("b", path("link"));
  fs::create_symlink(".", path("here"));
  base::FileTransaction transaction;
  ASSERT_TRUE(base::write_file(path("a"), "1").ok());
  EXPECT_FALSE(base::write_file(path("here/../a"), "2").ok() &&
               base::write_file(path("here/a"), "2").ok());
  ASSERT_TRUE(base::write_file(path("b"), "1").ok());
  EXPECT_FALSE(base::write_file(path("link"), "2").ok());
  ASSERT_TRUE(transaction.commit().ok());
  EXPECT_EQ(*base::read_file(path("a")), "1");
  EXPECT_EQ(*base::read_file(path("link")), "1");
}

TEST_F(FileTransactionTest, SignalsWaitForTheEndOfACommit) {
  // every signal of a child that commits in a loop finds all files of one number
  for (int attempt = 0; attempt < 10; ++attempt) {
    const pid_t child = ::fork();
    if (child == 0) {
      ::signal(SIGTERM, [](int) {
        base::remove_unfinished_files();
        ::_exit(0);
      });
      for (int k = 0;; ++k) {
        base::FileTransaction transaction;
        for (const char* name : {"a", "b", "c", "d"})
          if (!base::write_file(path(name), std::to_string(k))) ::_exit(1);
        if (!transaction.commit()) ::_exit(2);
      }
    }
    ::usleep(static_cast<useconds_t>(20000 + 1700 * attempt));
    ::kill(child, SIGTERM);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    if (entries() == 0) continue;  // a slow machine had not begun
    EXPECT_EQ(entries(), 4);
    const std::string content = *base::read_file(path("a"));
    for (const char* name : {"b", "c", "d"})
      EXPECT_EQ(*base::read_file(path(name)), content) << name;
  }
}

TEST_F(FileTransactionTest, ASignalRemovesNewFolders) {
  const pid_t child = ::fork();
  if (child == 0) {
    base::FileTransaction transaction;
    if (!base::make_folder(path("x/y")) || !base::write_file(path("x/y/a"), "1")) ::_exit(1);
    base::remove_unfinished_files();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(entries(), 0);
}

TEST_F(FileTransactionTest, DevicesAndDescriptorsAreWrittenDirectly) {
  const int fd = ::open(path("log").c_str(), O_CREAT | O_RDWR | O_APPEND, 0666);
  ASSERT_GE(fd, 0);
  ASSERT_EQ(::write(fd, "1", 1), 1);
  const std::string name = "/dev/fd/" + std::to_string(fd);
  fs::create_symlink(name, path("link"));
  {
    base::FileTransaction transaction;
    EXPECT_TRUE(base::write_file("/dev/null", "x").ok());
    EXPECT_TRUE(base::write_file("/dev/null", "x").ok());
    EXPECT_TRUE(base::write_file(name, "2").ok());
    EXPECT_TRUE(base::write_file(path("link"), "3").ok());
    EXPECT_TRUE(transaction.commit().ok());
  }
  ::close(fd);
  EXPECT_EQ(*base::read_file(path("log")), "123");  // neither replaced nor begun anew
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace limn
