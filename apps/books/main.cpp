/// The program `steradian-books`: renders the numbered pictures of the books and writes pages about them.
#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "steradian/apps/books/claims.h"
#include "steradian/apps/books/pages.h"
#include "steradian/apps/steradian/arguments.h"
#include "steradian/apps/steradian/console.h"
#include "steradian/apps/steradian/exit_codes.h"
#include "steradian/apps/steradian/parse.h"
#include "steradian/apps/steradian/program.h"

namespace {

using namespace steradian;
using namespace steradian::app;
using namespace steradian::books;

struct Options {
  std::string folder = "book";
  std::optional<std::string> only, threads;
  bool quick = false, list = false;
};

int work(const Options& options, Arguments& arguments) {
  if (options.list) {
    for (const auto* pictures : {&restOfYourLife(), &oneWeekend()})
      for (const books::NumberedPicture& picture : *pictures)
        printOut(fmt::format("{:<28} {}\n", picture.id, picture.title));
    return kExitSuccess;
  }
  const books::NumberedPicture* only = nullptr;
  if (options.only) {
    only = findPicture(*options.only);
    if (only == nullptr) arguments.problem(fmt::format("unknown picture \"{}\"; --list lists them", *options.only));
  }
  const std::uint32_t threads = options.threads ? arguments.whole("--threads", *options.threads, 1, 1024)
                                                : static_cast<std::uint32_t>(tbb::this_task_arena::max_concurrency());
  arguments.throwIfProblems();

  const std::filesystem::path folder = options.folder;
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw Error(ErrorKind::Output, fmt::format("cannot make the folder \"{}\"", folder.string()));

  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(static_cast<int>(threads));
  arena.execute([&] {
    const Effort effort{options.quick};
    if (only != nullptr) return writePicture(renderPicture(*only, effort), folder / only->file());
    Tally tally;
    writeInOneWeekend(folder, effort, tally);
    writeRestOfYourLife(folder, effort, tally);
    writeClaims(folder, effort, tally);
  });
  return kExitSuccess;
}

int runProgram(int argc, char** argv) {
  CLI::App app{
      "The numbered pictures of \"Ray Tracing in One Weekend\" and \"The Rest of Your Life\", and the books' claims "
      "as\n"
      "figures: writes PNG files, in-one-weekend.html, rest-of-your-life.html and claims.html"};
  app.name("steradian-books");
  app.set_version_flag("--version", STERADIAN_VERSION, "print the version");
  app.set_help_flag("-h,--help", "print this help");
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  Options options;
  app.add_option("-o,--output", options.folder, "where to write (book)")->option_text("FOLDER");
  app.add_option("--only", options.only, "render this picture and write no page")->option_text("PICTURE");
  app.add_option("-t,--threads", options.threads, "default: all processors")->option_text("N");
  app.add_flag("--quick", options.quick, "small and noisy, within a minute: to see that everything works");
  app.add_flag("--list", options.list, "list the pictures");
  app.footer("Exit codes: 0 done; 2 wrong usage; 71 out of memory; 74 output could not be written; 1 anything else.");
  Arguments arguments;
  if (const auto done = parse(app, argc, argv, arguments)) return *done;
  return work(options, arguments);
}

}  // namespace

int main(int argc, char** argv) {
  return steradian::app::runMain([&] { return runProgram(argc, argv); });
}
