/// Memory: what is needed is said before the work, and refused where there is less.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "limn/mesh/io/mesh_file.h"
#include "limn/surface/surface_estimate.h"
#include "run_command.h"
#include "support/sanitized.h"

namespace limn::test {
namespace {

const std::string kTetrahedron =
    "v 1 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\nf 1 2 4\nf 3 2 1\nf 1 4 3\nf 2 3 4\n";
const std::string kCube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// The most memory that was resident in a run, in bytes.
double peak_of(const Folder& folder, const std::vector<std::string>& arguments) {
  const pid_t child = ::fork();
  if (child == 0) {
    if (::chdir(folder.path().c_str()) != 0) ::_exit(99);
    if (std::freopen("/dev/null", "w", stdout) == nullptr) ::_exit(99);
    std::vector<char*> list{const_cast<char*>(LIMN_COMMAND)};
    for (const std::string& one : arguments) list.push_back(const_cast<char*>(one.c_str()));
    list.push_back(nullptr);
    ::execv(LIMN_COMMAND, list.data());
    ::_exit(99);
  }
  int status = 0;
  struct rusage usage {};
  ::wait4(child, &status, 0, &usage);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

TEST(Memory, TheForecastBoundsWhatIsTaken) {
  LIMN_SKIP_IF_SANITIZED();
  const Folder folder;
  folder.write("loop.obj", kTetrahedron);
  folder.write("sqrt3.obj", kTetrahedron);
  folder.write("catmull-clark.obj", kCube);
  folder.write("doo-sabin.obj", kCube);
  folder.write("b-spline-quad.obj", kCube);
  const double base =
      peak_of(folder, {"refine", "loop.obj", "-s", "loop", "-n", "1", "-o", "x.obj"});
  for (const std::string name : {"loop", "catmull-clark", "doo-sabin", "sqrt3", "b-spline-quad"}) {
    const Scheme scheme = *find_scheme(name);
    const Mesh mesh = *Mesh::build(*read_mesh(folder.file(name + ".obj")));
    const int levels = name == "sqrt3" ? 10 : 7;
    for (const bool quick : {true, false})
      for (const std::string what : {"", "--limit", "--curvatures=k.csv"}) {
        std::vector<std::string> job{"refine",   name + ".obj",
                                     "-s",       name,
                                     "-o",       "x.ply",
                                     "-n",       std::to_string(levels),
                                     "--engine", quick ? "quick" : "plain"};
        if (!what.empty()) job.push_back(what);
        const double taken = peak_of(folder, job) - base;
        const refine::RefineEstimate estimate =
            surface::estimate_with_limit(scheme, mesh, levels,
                                         {.quick = quick,
                                          .limit = what == "--limit",
                                          .curvatures = what.size() > 9,
                                          .written = quick});
        constexpr double kFixed = 4e6;  // threads' own memory, the file's buffers
        EXPECT_LE(taken, estimate.peak_bytes + kFixed) << name << quick << what;
        EXPECT_GE(taken, 0.4 * estimate.peak_bytes - kFixed) << name << quick << what;
      }
  }
}

TEST(Memory, IsRefusedBeforeTheWorkWhereAUlimitLeavesLess) {
  LIMN_SKIP_IF_SANITIZED();
  const Folder folder;
  folder.write("t.obj", kTetrahedron);
  for (const std::string limit : {"ulimit -v 3000000", "ulimit -d 3000000"})
    for (const std::string& job :
         {std::string("refine t.obj -s loop -n 14 -o a.ply"),
          std::string("refine t.obj -s loop -n 11 --curvatures c.csv -o a.ply"),
          std::string("draw t.obj -s loop -n 11 -o a.png")}) {
      if (limit.find("-d") != std::string::npos && job.find("draw") != std::string::npos) continue;
      expect_refused(folder.shell(limit + "; \"$LIMN\" " + job),
                     {"levels", "vertices", "need about", "are free"});
    }
  EXPECT_EQ(folder.count(), 1);
}

TEST(Memory, WhatRunsOutOfItNamesTheStep) {
  LIMN_SKIP_IF_SANITIZED();
  const Folder folder;
  folder.write("t.obj", kTetrahedron);
  std::filesystem::resize_file(folder.file("t.obj"), 900'000'000);
  const Outcome outcome =
      folder.shell("ulimit -v 600000; \"$LIMN\" refine t.obj -s loop -n 1 -o a.ply");
  expect_refused(outcome, {"t.obj"});
}

TEST(Memory, FilesAreBoundedInKindAndSize) {
  const Folder folder;
  folder.write("big.toml", "");
  std::filesystem::resize_file(folder.file("big.toml"), 1'000'000'000);
  std::filesystem::create_symlink("/dev/zero", folder.file("zero.toml"));
  std::filesystem::create_symlink("/dev/zero", folder.file("zero.obj"));
  std::filesystem::create_directory(folder.file("folder.obj"));
  const Outcome made = folder.shell("mkfifo pipe.toml");
  ASSERT_EQ(made.code, 0);
  for (const std::string bad :
       {"/dev/zero", "./zero.toml", "./pipe.toml", "./big.toml", "/dev/tty", "."}) {
    expect_refused(folder.limn("show " + bad, "timeout 10"), {bad + ": cannot read"});
    expect_refused(folder.limn("compare loop " + bad + " --valence 5", "timeout 10"),
                   {bad + ": cannot read"});
  }
  for (const std::string bad : {"zero.obj", "folder.obj"})
    expect_refused(folder.limn("refine " + bad + " -s loop -o a.obj", "timeout 10"),
                   {bad + ": cannot read", "but a"});
  // a pipe of a mesh is read to its end
  const Outcome piped = folder.shell("mkfifo pipe.obj; cat '" LIMN_EXAMPLES
                                     "/bracket.obj' >pipe.obj & \"$LIMN\" refine pipe.obj -s loop "
                                     "-n 1 -o a.obj");
  EXPECT_EQ(piped.code, 0) << piped.err;
}

}  // namespace
}  // namespace limn::test
