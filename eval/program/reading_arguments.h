// SPDX-License-Identifier: BSD-3-Clause
// The options of the command lines that say what the numbers of an input are.
#pragma once

#include <string>

#include "datasets/sources/frame_source.h"
#include "datasets/sources/reading_options.h"

namespace CLI {
class App;
}

namespace epcc {

/// --projection, --unit, --min-depth, --max-depth, --invalid and --distance as typed.
struct ReadingArguments {
  std::string projection = "auto";
  std::string unit;  ///< empty: not said
  ReadingOptions options;
};

/// Adds them in a group of their own; `arguments` must outlive the reading of the command line. The first adds those
/// for depth images alone.
void addDepthArguments(CLI::App& app, ReadingArguments& arguments);
void addReadingArguments(CLI::App& app, ReadingArguments& arguments);

/// What they say, once the command line was read; `problem` is empty if all is well.
ReadingOptions readingOptions(const ReadingArguments& arguments, std::string& problem);

/// Which kinds of frames there are.
struct FrameKinds {
  bool has_clouds = false;
  bool has_depth_images = false;

  /// A file, by its name.
  void add(const std::string& file);
  /// All frames of a data set.
  void add(const FrameSource& source);
};

/// Names the option that none of the frames has a use for; empty if there is none, or no frame.
std::string uselessOption(const ReadingOptions& options, const FrameKinds& kinds);

/// The options as they are typed, empty if none was.
std::string readingText(const ReadingOptions& options);

}  // namespace epcc
