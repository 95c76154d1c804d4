#include "commands/gnuplot.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <thread>

#include "base/machine.hpp"
#include "base/memory_file.hpp"
#include "base/signals.hpp"
#include "core/errors.hpp"

namespace ehl::program {
namespace {

namespace files = std::filesystem;

constexpr auto wake_interval = std::chrono::milliseconds(5);
constexpr int not_started = 127;  // the status by which a shell reports that the program was not found

[[noreturn]] void be_gnuplot(const std::string& settings, const std::string& script, pid_t parent) {
  ::signal(SIGPIPE, SIG_DFL);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(not_started);
  ::setenv("LC_ALL", "C.UTF-8", 1);  // the scripts are in UTF-8 and need decimal points, whatever the locale is
  ::execlp("gnuplot", "gnuplot", "-e", settings.c_str(), script.c_str(), static_cast<char*>(nullptr));
  ::_exit(not_started);
}

void run_gnuplot(const std::string& settings, const std::string& script, const std::string& figure) {
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) throw core::FileError(std::string("gnuplot cannot be started: ") + std::strerror(errno));
  if (child == 0) be_gnuplot(settings, script, parent);
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (stop_requested()) ::kill(child, SIGKILL);
    std::this_thread::sleep_for(wake_interval);
  }
  if (stop_requested()) throw core::Interrupted();
  if (WIFEXITED(status) && WEXITSTATUS(status) == not_started) throw core::FileError(no_gnuplot);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw core::FileError("gnuplot failed on figure " + figure + "; its message is above");
}

std::string gnuplot_text(const std::vector<Setting>& settings) {
  std::string text;
  for (const Setting& one : settings)
    text += (text.empty() ? "" : "; ") + one.name + "=" + (one.is_text ? gnuplot_literal(one.value) : one.value);
  return text;
}

}  // namespace

std::string gnuplot_literal(const std::string& text) {
  std::string literal = "\"";
  bool in_octal = false;  // gnuplot reads every digit that follows as a part of the number
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    const bool plain = code >= 0x80 || std::isalnum(code) != 0 || std::strchr(" ./_-", c) != nullptr;
    const bool as_it_is = plain && c != '\0' && !(in_octal && std::isdigit(code) != 0);
    literal += as_it_is ? std::string(1, c) : fmt::format("\\{:03o}", code);
    in_octal = !as_it_is;
  }
  return literal + "\"";
}

std::string no_pipe(const std::string& path) { return files::path(path).is_absolute() ? path : "./" + path; }

PlainNames::~PlainNames() {
  std::error_code error;
  if (!folder_.empty()) files::remove_all(folder_, error);  // removes the links but not the files they point to
}

std::string PlainNames::of(const std::string& path, const std::string& link) {
  if (path.find('\'') == std::string::npos) return no_pipe(path);
  std::error_code error;
  if (folder_.empty()) {
    std::string name = files::temp_directory_path(error).string();
    if (error || name.find('\'') != std::string::npos) name = "/tmp";
    name += "/ehl_plot_XXXXXX";
    if (::mkdtemp(name.data()) == nullptr)
      throw core::FileError(name + ": a folder for links cannot be made: " + std::strerror(errno));
    folder_ = name;
  }
  const std::string plain = folder_ + "/" + link;
  files::create_symlink(files::absolute(path), plain, error);
  if (error) throw core::FileError(plain + ": a link cannot be made: " + error.message());
  return plain;
}

Gnuplot::Gnuplot(const std::string& path, const FigureSource& source, const std::string& format)
    : scripts_(names_.of(folder_of_scripts(), "scripts")),
      settings_{{"file", names_.of(path, "data")}, {"ehl", names_.of(program_path(), "ehl")}, {"format", format}} {
  settings_.insert(settings_.end(), source.settings.begin(), source.settings.end());
}

void Gnuplot::draw(const Figure& figure, std::vector<Setting> own, const std::string& output,
                   const Curves* curves) const {
  own.insert(own.begin(), settings_.begin(), settings_.end());
  own.push_back({"output", output});
  const MemoryFile rows;
  if (curves != nullptr) {
    own.insert(own.end(), curves->settings.begin(), curves->settings.end());
    rows.hold(curves->data);
    own.push_back({"data", rows.name()});
  }
  run_gnuplot(gnuplot_text(own), scripts_ + "/" + files::path(figure.script).filename().string(), figure.name);
}

}  // namespace ehl::program
