// SPDX-License-Identifier: BSD-3-Clause
// epcc_bench: milliseconds a frame of both modes, their variants, the PCL class, floors and PCL's own methods.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cstring>
#include <exception>
#include <iostream>
#include <string>

#include "epcc_segmentation/vector_unit.h"
#include "tests/bench/cases.h"
#include "tests/bench/ratios.h"

namespace {

const char kHelp[] = R"(epcc_bench [--frames DIR] [Google Benchmark's options]
Milliseconds a frame on rendered scenes, one thread unless the name says otherwise, and ratios of them.

  --frames DIR                  also the frames of a folder (NAME_depth.png, NAME.json): cases METHOD/frames/NAME and
                                the medians over all; needs no _labels.png
  --version                     prints the version
  --help                        prints this
  --benchmark_filter=REGEX      only cases whose name matches, for example '/640x480' or '^Default/frames'
  --benchmark_list_tests=true   names them
  --benchmark_min_time=SECONDS  at least so long each, default 0.5
  --benchmark_repetitions=N     the ratios are those of the medians
  --benchmark_format=json       the ratios go to the error output; --benchmark_out=FILE writes JSON besides

Cases: Floor, FloorWeights, FloorStatistics (passes that do a part of the work and nothing else), Sensor (the noise
measured), Auto (whole frames, the noise measured on each), AutoStream (on a stream that has settled), Paper, Default,
PclClass, PclClassRGB, PclOrganizedMultiPlane, PclRegionGrowing, PclRansac at WxH; variants /threads:N, /uint16, /stride:N and
/unit:NAME; Noise/xF and Scene/NAME: default mode against noise, clutter and number of planes.
Counters are milliseconds by stage and the number of planes found. The pages of docs/reference/ say more.
)";

/// The own options, which are taken out of the list.
struct Options {
  std::string frames, problem;
  bool help = false, version = false, json = false, csv = false;

  Options(int& argc, char** argv) {
    int kept = 1;
    for (int i = 1; i < argc; ++i) {
      const std::string text = argv[i];
      const std::string frames_is = "--frames=";
      if (text == "--help" || text == "-h")
        help = true;
      else if (text == "--version")
        version = true;
      else if (text == "--frames" && i + 1 < argc)
        frames = argv[++i];
      else if (text.rfind(frames_is, 0) == 0)
        frames = text.substr(frames_is.size());
      else if (text == "--frames")
        problem = "--frames needs a folder";
      else
        argv[kept++] = argv[i];
      json = json || text == "--benchmark_format=json";
      csv = csv || text == "--benchmark_format=csv";
    }
    argc = kept;
  }
};

int run(const Options& options) {
  if (options.csv) {  // no reporter to pass it on to
    benchmark::RunSpecifiedBenchmarks();
    return 0;
  }
  benchmark::AddCustomContext("vector_unit", epcc::vectorUnit());
  benchmark::JSONReporter json;
  benchmark::ConsoleReporter console(isatty(STDOUT_FILENO) != 0 ? benchmark::ConsoleReporter::OO_Color
                                                                : benchmark::ConsoleReporter::OO_None);
  benchmark::BenchmarkReporter* shown = &console;
  if (options.json) shown = &json;
  epcc::bench::CollectingReporter reporter(*shown);
  benchmark::RunSpecifiedBenchmarks(&reporter);
  epcc::bench::printRatios(reporter.times(), options.json ? std::cerr : std::cout);
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  const Options options(argc, argv);
  if (options.help) {
    std::cout << kHelp;
    return 0;
  }
  if (options.version) {
    std::cout << "epcc_bench " << EPCC_VERSION << '\n';
    return 0;
  }
  benchmark::Initialize(&argc, argv);
  if (!options.problem.empty()) {
    std::cerr << "epcc_bench: " << options.problem << '\n';
    return 2;
  }
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  if (!epcc::vectorUnitProblem().empty()) {
    std::cerr << "epcc_bench: " << epcc::vectorUnitProblem() << '\n';
    return 2;
  }
  epcc::bench::addRenderedCases();
  if (!options.frames.empty()) epcc::bench::addFolderCases(options.frames);
  const int code = run(options);
  benchmark::Shutdown();
  return code;
} catch (const std::exception& error) {
  std::cerr << "epcc_bench: " << error.what() << '\n';
  return 3;
}
