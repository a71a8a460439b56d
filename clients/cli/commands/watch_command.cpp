// selvage watch: follows a marker that is open on a daemon, one line for how it is and one for every change.
#include <condition_variable>
#include <deque>
#include <iostream>
#include <memory>
#include <mutex>

#include "clients/cli/commands/commands.h"
#include "clients/cli/run/remote.h"
#include "clients/cli/terminal/interrupt.h"
#include "clients/cli/terminal/summary.h"
#include "protocol/json/json_text.h"

namespace selvage::cli::commands {
namespace {

struct WatchOptions {
  std::string marker;
  bool json{};
  run::ServerChoice server;
};

struct Event {
  enum class Kind { kChanged, kClosed, kReconnected, kLost, kInterrupted } kind{};
  Json params;          // of a change
  std::string message;  // of a loss
};

// What the client's thread tells the one that prints.
class Events {
 public:
  void add(Event event) {
    const std::lock_guard lock{mutex_};
    events_.push_back(std::move(event));
    added_.notify_one();
  }
  Event next() {
    std::unique_lock lock{mutex_};
    added_.wait(lock, [this] { return !events_.empty(); });
    Event event = std::move(events_.front());
    events_.pop_front();
    return event;
  }

 private:
  std::mutex mutex_;
  std::condition_variable added_;
  std::deque<Event> events_;
};

client::Handlers tell(Events& events) {
  return {.notified =
              [&events](std::string_view method, const Json& params) {
                if (method == "marker.changed") events.add({Event::Kind::kChanged, params, ""});
                if (method == "marker.closed") events.add({Event::Kind::kClosed, {}, ""});
              },
          .reconnected =
              [&events] {
                events.add({Event::Kind::kReconnected, {}, ""});
              },
          .lost =
              [&events](const client::CallError& error) {
                events.add({Event::Kind::kLost, {}, error.message});
              }};
}

// Prints a marker's figures, each revision once.
class Watch {
 public:
  Watch(const WatchOptions& options, client::Client& client) : options_{options}, client_{client} {}

  // {"markerId", "revision", "by"?, "name", "pieces", "length", "utilisation", "valid"}, perhaps among others
  void print(const Json& figures) {
    const auto revision = figures.value("revision", std::uint64_t{0});
    if (revision <= printed_) return;
    printed_ = revision;
    std::cout << (options_.json ? protocol::json::to_text(figures) : terminal::plain_change(figures)) << std::endl;
  }
  // Prints how the marker is now, when that is news.
  std::optional<run::Refusal> catch_up() {
    for (;;) {
      const client::Answer checked = client_.call("marker.check", {{"markerId", options_.marker}});
      if (!checked) return run::refusal_of(checked.error());
      const client::Answer listed = client_.call("marker.list");
      if (!listed) return run::refusal_of(listed.error());
      for (Json figures : (*listed)["markers"]) {
        if (figures["markerId"] != options_.marker || figures["revision"] != (*checked)["revision"]) continue;
        figures["valid"] = (*checked)["valid"];
        print(figures);
        return std::nullopt;
      }
    }  // it changed in between: once more
  }

 private:
  const WatchOptions& options_;
  client::Client& client_;
  std::uint64_t printed_{};
};

terminal::ExitCode follow(Watch& watch, Events& events) {
  for (;;) {
    const Event event = events.next();
    switch (event.kind) {
      case Event::Kind::kChanged: watch.print(event.params); break;
      case Event::Kind::kReconnected:
        if (const auto refusal = watch.catch_up()) return fail(*refusal);
        break;
      case Event::Kind::kLost: return run::fail({event.message, terminal::ExitCode::kServer});
      case Event::Kind::kClosed:
      case Event::Kind::kInterrupted: return terminal::ExitCode::kOk;
    }
  }
}

terminal::ExitCode run(const WatchOptions& options) {
  const terminal::Interrupt interrupt;
  Events events;
  const std::stop_callback on_interrupt{interrupt.token(), [&events] {
                                          events.add({Event::Kind::kInterrupted, {}, ""});
                                        }};
  const auto reached = reach(options.server, tell(events));
  if (const auto* refusal = std::get_if<run::Refusal>(&reached)) return fail(*refusal);
  client::Client& client = *std::get<std::unique_ptr<client::Client>>(reached);
  const client::Answer watching = client.call("marker.watch", {{"markerId", options.marker}});
  if (!watching) return fail(run::refusal_of(watching.error()));
  Watch watch{options, client};
  if (const auto refusal = watch.catch_up()) return fail(*refusal);
  return follow(watch, events);
}

}  // namespace

void add_watch_command(CLI::App& app, terminal::ExitCode& code) {
  auto options = std::make_shared<WatchOptions>();
  CLI::App* command = app.add_subcommand("watch", "Follow the changes of a marker on a daemon (--server)");
  command->add_option("MARKER", options->marker, "Its id there, such as m1")->required();
  command->add_flag("--json", options->json, "Print every change as one line of JSON, as the daemon tells it");
  command->footer(terminal::kExitCodesHelp);
  command->callback([options, command, &code] {
    options->server = run::server_choice(*command);
    if (!options->server) throw CLI::RequiredError("--server");
    code = run(*options);
  });
}

}  // namespace selvage::cli::commands
