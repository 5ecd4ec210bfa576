/// Formats told by content, and meshes read from streams.

#include <gtest/gtest.h>

#include <sstream>

#include "limn/base/wide_text.h"
#include "limn/mesh/io/mesh_file.h"
#include "mesh/io/mesh_samples.h"

namespace limn {
namespace {

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST(FormatOfContent, KnowsWhatLimnWrites) {
  for (const std::string extension : {"obj", "off", "ply", "stl"}) {
    const std::string content = *format_mesh(extension, test::cube());
    EXPECT_EQ(format_of_content(content).value(), extension);
    std::istringstream in(content);
    const Result<MeshFile> file = read_mesh_file(in, "standard input");
    ASSERT_TRUE(file.ok()) << file.error().text();
    EXPECT_EQ(file->polygons, parse_mesh(content, extension, "").value());
    EXPECT_EQ(file->source.file, "standard input");
  }
}

TEST(FormatOfContent, KnowsWhatOthersWrite) {
  const std::string mark = "\xEF\xBB\xBF";
  std::string solid_head = *format_mesh("stl", test::cube());
  solid_head.replace(0, 11, "solid model");
  const std::string ascii_stl =
      "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\nendsolid\n";
  struct Known {
    std::string content, format;
  };
  for (const Known& known :
       {Known{"# Blender\n\nmtllib a.mtl\no Cube\n" + kObj, "obj"}, Known{mark + kObj, "obj"},
        Known{"mystatement 1\n" + kObj, "obj"}, Known{"\n  \t# c\n  g\n" + kObj, "obj"},
        Known{"OFF4 4 0\n", "off"}, Known{"# c\noff\n", "off"}, Known{"STCNOFF\n", "off"},
        Known{"3 1 0\n0 0 0\n", "off"}, Known{mark + "OFF\n", "off"},
        Known{"ply\r\nformat ascii 1.0\r\n", "ply"}, Known{mark + "ply\n", "ply"},
        Known{"SOLID x\n", "stl"}, Known{mark + ascii_stl, "stl"}, Known{solid_head, "stl"},
        Known{std::string(100, '\0'), "stl"}, Known{"glTF\2", "glb"},
        Known{"\n{ \"asset\": {}}", "gltf"}})
    EXPECT_EQ(format_of_content(known.content).value(), known.format) << known.content;
}

TEST(FormatOfContent, SaysWhyItCannotTell) {
  struct Unknown {
    std::string content, message;
  };
  for (const Unknown& unknown :
       {Unknown{"", "no content"}, Unknown{"\x1f\x8b\x08", "gzip"}, Unknown{"{}", "no format"},
        Unknown{"\xFF\xFEv", "UTF-16"}, Unknown{"<?xml version='1.0'?>", "XML"},
        Unknown{"hello world\nfoo\n", "no format"}, Unknown{"# only a comment\n", "no format"}}) {
    const Result<std::string> format = format_of_content(unknown.content);
    ASSERT_FALSE(format.ok()) << unknown.content;
    EXPECT_NE(format.error().message.find(unknown.message), std::string::npos)
        << format.error().message;
    std::istringstream in(unknown.content);
    const Result<MeshFile> file = read_mesh_file(in, "standard input");
    ASSERT_FALSE(file.ok());
    EXPECT_EQ(file.error().file, "standard input");
  }
}

TEST(ReadMesh, WideTextIsRefusedWithTheRightRemedy) {
  const std::string obj = "# caf\xE9\n" + *format_mesh("obj", test::cube());  // Latin 1
  struct Encoding {
    const char* name;
    std::size_t size;
    bool big_endian, mark;
  };
  for (const Encoding& e :
       {Encoding{"UTF-16", 2, false, true}, Encoding{"UTF-16", 2, true, true},
        Encoding{"UTF-16LE", 2, false, false}, Encoding{"UTF-16BE", 2, true, false},
        Encoding{"UTF-32", 4, false, true}, Encoding{"UTF-32", 4, true, true},
        Encoding{"UTF-32LE", 4, false, false}, Encoding{"UTF-32BE", 4, true, false}}) {
    std::string text;
    const auto add = [&](unsigned c) {
      for (std::size_t k = 0; k < e.size; ++k)
        text += static_cast<char>(c >> 8 * (e.big_endian ? e.size - 1 - k : k) & 255);
    };
    if (e.mark) add(0xfeff);
    for (const char c : obj) add(static_cast<unsigned char>(c));
    for (const char* extension : {"obj", "off", "ply", "stl", ""}) {
      const Result<MeshFile> file = parse_mesh_file(text, extension, "a");
      ASSERT_FALSE(file.ok());
      const std::string name = e.name;
      EXPECT_EQ(file.error().message, "the file is " + name.substr(0, 6) + " text") << name;
      EXPECT_EQ(file.error().hint, "convert it to UTF-8: iconv -f " + name + " -t UTF-8");
    }
  }
  // Every format's own files, and text of few or many bytes beyond ASCII, are none of these.
  for (const char* extension : {"obj", "off", "ply", "stl", "glb"})
    EXPECT_EQ(base::wide_encoding(*format_mesh(extension, test::cube())), "") << extension;
  for (const std::string& text :
       {std::string(), std::string("OFF"), std::string(400, '\0'), std::string(400, '\xff'),
        std::string("v 0 0 0\n"), std::string("\xE6\xA8\xA1\xE5\x9E\x8B")})
    EXPECT_EQ(base::wide_encoding(text), "");
}

TEST(ReadMesh, WhatAForeignFileIsIsToldWhateverItsName) {
  struct Foreign {
    std::string content, part;
  };
  for (const Foreign& foreign :
       {Foreign{std::string("\x1f\x8b\x08\0", 4) + "zz", "gzip"},
        Foreign{"<!DOCTYPE html>\n<html>\n", "HTML"},
        Foreign{"version https://git-lfs.github.com/spec/v1\noid sha256:4d\nsize 12\n", "Git LFS"},
        Foreign{std::string("\x89PNG\r\n\x1a\n\0\0", 10), "PNG"}}) {
    for (const char* extension : {"obj", "off", "ply", "stl"}) {
      const Result<MeshFile> file = parse_mesh_file(foreign.content, extension, "a");
      ASSERT_FALSE(file.ok());
      EXPECT_NE(file.error().hint.find(foreign.part), std::string::npos)
          << extension << ": " << file.error().text();
    }
  }
  // A NUL alone makes no STL file.
  EXPECT_EQ(parse_mesh_file(std::string("x\0\1\2", 4), "off", "a").error().hint, "");
}

TEST(ReadMesh, AByteOrderMarkOfUtf8IsNoContent) {
  const std::string mark = "\xEF\xBB\xBF";
  for (const std::string extension : {"obj", "off"}) {
    const std::string text = *format_mesh(extension, test::cube());
    EXPECT_EQ(parse_mesh(mark + text, extension, "").value(), test::cube());
  }
  EXPECT_EQ(parse_mesh(mark + *format_mesh("ply", test::cube()), "ply", "").value(), test::cube());
}

}  // namespace
}  // namespace limn
