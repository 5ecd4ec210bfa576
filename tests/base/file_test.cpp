#include "limn/base/files/file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <thread>

#include "support/temporary_folder.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

class FileTest : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const char* name) const { return temporary_ / name; }
  [[nodiscard]] int entries() const {
    return static_cast<int>(std::distance(fs::directory_iterator(folder_), {}));
  }
  static mode_t mode(const std::string& path) {
    struct stat info {};
    return ::stat(path.c_str(), &info) == 0 ? info.st_mode & 0777 : 0;
  }
  test::TemporaryFolder temporary_;
  const fs::path& folder_ = temporary_.path();
};

TEST_F(FileTest, WritesReadsAndReplaces) {
  const std::string content("a\0b\xff\n", 5);
  ASSERT_TRUE(base::write_file(path("a"), content).ok());
  EXPECT_EQ(*base::read_file(path("a")), content);
  const std::string large(300000, 'x');
  ASSERT_TRUE(base::write_file(path("a"), large).ok());
  EXPECT_EQ(*base::read_file(path("a")), large);
  ASSERT_TRUE(base::write_file(path("a"), "").ok());
  EXPECT_EQ(*base::read_file(path("a")), "");
  EXPECT_EQ(entries(), 1);  // no temporary file is left
}

TEST_F(FileTest, NewFilesRespectTheUmaskAndOldOnesKeepTheirMode) {
  const mode_t old = ::umask(027);
  ASSERT_TRUE(base::write_file(path("a"), "1").ok());
  EXPECT_EQ(mode(path("a")), 0640u);
  ::chmod(path("a").c_str(), 0755);
  ASSERT_TRUE(base::write_file(path("a"), "2").ok());
  EXPECT_EQ(mode(path("a")), 0755u);
  ::umask(old);
}

TEST_F(FileTest, LinksStayLinks) {
  ASSERT_TRUE(base::write_file(path("target"), "1").ok());
  fs::create_directory(path("folder"));
  fs::create_symlink("../target", path("folder/link"));
  ASSERT_TRUE(base::write_file(path("folder/link"), "2").ok());
  EXPECT_TRUE(fs::is_symlink(path("folder/link")));
  EXPECT_EQ(*base::read_file(path("target")), "2");
  fs::create_symlink("not-yet", path("dangling"));
  ASSERT_TRUE(base::write_file(path("dangling"), "3").ok());
  EXPECT_TRUE(fs::is_symlink(path("dangling")));
  EXPECT_EQ(*base::read_file(path("not-yet")), "3");
  fs::create_symlink("loop", path("loop"));
  EXPECT_FALSE(base::write_file(path("loop"), "4").ok());
}

TEST_F(FileTest, ErrorsNameThePathAndLeaveNothing) {
  for (const std::string& bad : {path("none/a"), folder_.string(), std::string()}) {
    const Status status = base::write_file(bad, "x");
    ASSERT_FALSE(status.ok()) << bad;
    EXPECT_EQ(status.error().file, bad);
    EXPECT_FALSE(status.error().message.empty());
    EXPECT_FALSE(base::read_file(bad).ok());
  }
  EXPECT_EQ(entries(), 0);
  EXPECT_FALSE(base::read_file(path("missing")).ok());
  if (fs::exists("/dev/full")) EXPECT_FALSE(base::write_file("/dev/full", "x").ok());
}

TEST_F(FileTest, AFailedWriteKeepsTheOldContent) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  ASSERT_TRUE(base::write_file(path("a"), "old").ok());
  ::chmod(path("a").c_str(), 0444);
  EXPECT_FALSE(base::write_file(path("a"), "new").ok());
  EXPECT_EQ(*base::read_file(path("a")), "old");
}

TEST_F(FileTest, PiecesFollowEachOther) {
  const auto fill = [](const base::Sink& sink) {
    for (const char* piece : {"a", "", "bc", "d"}) sink(piece);
  };
  ASSERT_TRUE(base::write_file(path("a"), fill).ok());
  EXPECT_EQ(*base::read_file(path("a")), "abcd");
}

TEST_F(FileTest, WhatIsThrownBetweenPiecesLeavesTheOldContent) {
  ASSERT_TRUE(base::write_file(path("a"), "old").ok());
  const auto fill = [](const base::Sink& sink) {
    sink("new");
    throw std::bad_alloc();
  };
  EXPECT_THROW((void)base::write_file(path("a"), fill), std::bad_alloc);
  EXPECT_EQ(*base::read_file(path("a")), "old");
  EXPECT_EQ(entries(), 1);
}

TEST_F(FileTest, PiecesComeInAnyOrderFromAnyThread) {
  std::string content(300000, ' ');
  for (std::size_t i = 0; i < content.size(); ++i) content[i] = static_cast<char>('a' + i % 23);
  const auto fill = [&](const base::PlacedSink& sink) -> Status {
    const auto part = [&](std::size_t begin, std::size_t end) {
      for (std::size_t at = end; at > begin; at -= 1000)
        sink(at - 1000, std::string_view(content).substr(at - 1000, 1000));
    };
    std::thread other([&] { part(150000, 300000); });
    part(0, 150000);
    other.join();
    return Done{};
  };
  ASSERT_TRUE(base::takes_places(path("a")));
  ASSERT_TRUE(base::write_file_at_places(path("a"), fill).ok());
  EXPECT_EQ(*base::read_file(path("a")), content);
  EXPECT_EQ(entries(), 1);
}

TEST_F(FileTest, AnErrorOfWhoFillsPlacesLeavesTheOldContent) {
  ASSERT_TRUE(base::write_file(path("a"), "old").ok());
  const Status status =
      base::write_file_at_places(path("a"), [](const base::PlacedSink& sink) -> Status {
        sink(3, "new");
        return Error{"no more"};
      });
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().message, "no more");
  EXPECT_EQ(*base::read_file(path("a")), "old");
  EXPECT_EQ(entries(), 1);
}

TEST_F(FileTest, PipesAndDescriptorsHaveNoPlaces) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  for (const std::string& none : {path("pipe"), std::string("-"), std::string("/dev/stdout"),
                                  std::string("/dev/null"), std::string()})
    EXPECT_FALSE(base::takes_places(none)) << none;
}

TEST_F(FileTest, AFullDiskIsSaidOnce) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  int pieces = 0;
  const Status status = base::write_file("/dev/full", [&](const base::Sink& sink) {
    for (; pieces < 3; ++pieces) sink("x");
  });
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().file, "/dev/full");
  EXPECT_EQ(pieces, 3);
}

TEST_F(FileTest, PipesAreWrittenAndReadDirectly) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const std::string content(200000, 'y');
  std::thread writer([&] { EXPECT_TRUE(base::write_file(path("pipe"), content).ok()); });
  EXPECT_EQ(*base::read_file(path("pipe")), content);
  writer.join();
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

TEST_F(FileTest, OnlyFilesAndPipesAreRead) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", path("zero"));
  const base::ReadBound files_only{.bytes = 0, .pipes = false};
  for (const std::string& bad :
       {std::string("/dev/zero"), path("zero"), std::string("/dev/tty"), folder_.string()}) {
    const Result<std::string> content = base::read_file(bad);
    ASSERT_FALSE(content.ok()) << bad;
    EXPECT_EQ(content.error().file, bad);
  }
  const Result<std::string> pipe = base::read_file(path("pipe"), files_only);  // and does not wait
  ASSERT_FALSE(pipe.ok());
  EXPECT_NE(pipe.error().message.find("a pipe"), std::string::npos) << pipe.error().text();
}

TEST_F(FileTest, NoMoreIsReadThanTheBound) {
  const base::ReadBound hundred{.bytes = 100};
  ASSERT_TRUE(base::write_file(path("a"), std::string(100, 'x')).ok());
  EXPECT_EQ(base::read_file(path("a"), hundred)->size(), 100u);
  ASSERT_TRUE(base::write_file(path("a"), std::string(101, 'x')).ok());
  const Result<std::string> content = base::read_file(path("a"), hundred);
  ASSERT_FALSE(content.ok());
  EXPECT_NE(content.error().message.find("larger than"), std::string::npos);
  // sizes that nothing tells before reading
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  for (const std::size_t size : {std::size_t{100}, std::size_t{101}, std::size_t{300000}}) {
    std::thread writer([&] {
      ::signal(SIGPIPE, SIG_IGN);
      (void)base::write_file(path("pipe"), std::string(size, 'y'));
    });
    EXPECT_EQ(base::read_file(path("pipe"), hundred).ok(), size == 100) << size;
    writer.join();
  }
  // eight terabytes, by its size, where the file system has such files
  if (::truncate(path("a").c_str(), off_t{1} << 43) == 0)
    EXPECT_FALSE(base::read_file(path("a")).ok());
}

TEST_F(FileTest, WhatCannotBeWrittenIsKnownBefore) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  fs::create_symlink("new", path("link"));
  fs::create_symlink("loop", path("loop"));
  for (const std::string& good : {path("a"), path("link"), path("pipe"), std::string("/dev/null"),
                                  std::string("-"), std::string("/dev/stdout")})
    EXPECT_TRUE(base::check_can_write(good).ok()) << good;
  for (const std::string& bad : {std::string(), folder_.string(), path("none/a"), path("a/"),
                                 path("loop"), std::string("/dev/fd/987")}) {
    const Status status = base::check_can_write(bad);
    ASSERT_FALSE(status.ok()) << bad;
    EXPECT_EQ(status.error().file, bad);
  }
  EXPECT_EQ(entries(), 3);
}

TEST_F(FileTest, OutputsIntoOnePlace) {
  ASSERT_TRUE(base::write_file(path("a"), "x").ok());
  fs::create_hard_link(path("a"), path("b"));
  fs::create_symlink("new", path("link"));
  fs::create_symlink(".", path("here"));
  EXPECT_TRUE(base::is_same_output(path("a"), path("b")));
  EXPECT_TRUE(base::is_same_output(path("link"), path("here/new")));
  EXPECT_TRUE(base::is_same_output("not-there.pdf", "./not-there.pdf"));
  EXPECT_TRUE(base::is_same_output("-", "/dev/stdout"));
  EXPECT_FALSE(base::is_same_output("-", "./-"));
  EXPECT_FALSE(base::is_same_output(path("a"), path("new")));
  EXPECT_FALSE(base::is_same_output("/dev/null", "/dev/null"));
}

TEST_F(FileTest, ConcurrentWritesAreWhole) {
  std::vector<std::thread> threads;
  for (char c = 'a'; c < 'a' + 24; ++c) {
    threads.emplace_back([&, c] {
      for (int k = 0; k < 20; ++k) {
        EXPECT_TRUE(base::write_file(path("shared"), std::string(5000, c)).ok());
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  const std::string content = *base::read_file(path("shared"));
  EXPECT_EQ(content, std::string(5000, content[0]));
  EXPECT_EQ(entries(), 1);
}

/// A process is interrupted in the middle of writes; its handler tidies up and exits.
TEST_F(FileTest, AnInterruptLeavesNoTemporaryFile) {
  for (int attempt = 0; attempt < 10; ++attempt) {
    const pid_t child = ::fork();
    if (child == 0) {
      ::signal(SIGTERM, [](int) {
        base::remove_unfinished_files();
        ::_exit(0);
      });
      const std::string content(1 << 22, 'z');
      for (;;) (void)base::write_file(path("a"), content);
    }
    ::usleep(static_cast<useconds_t>(20000 + 3000 * attempt));
    ::kill(child, SIGTERM);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_LE(entries(), 1);
    for (const auto& entry : fs::directory_iterator(folder_)) {
      EXPECT_EQ(entry.path().filename(), "a");
    }
  }
}

}  // namespace
}  // namespace limn
