// The Python module selvage_engine._engine: Engine and Stop.  The only file that includes pybind11.
#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

#include "clients/engine/engine.h"

namespace py = pybind11;
using selvage::engine::Caller;
using selvage::engine::Engine;

namespace {

using OnRound = std::function<void(int, double, std::optional<double>, std::optional<std::uint64_t>)>;

// Releases the global interpreter lock, so that other Python threads can run; `on_round` acquires it for each call.
std::string answer(Engine& engine, const std::string& request, const std::stop_source& stop, const OnRound& on_round) {
  Caller caller{.stop = stop.get_token()};
  if (on_round) {  // empty when Python passed None
    caller.on_round = [&on_round](const selvage::engine::Round& round) {
      on_round(round.number, round.length, round.bound, round.nodes);
    };
  }
  const py::gil_scoped_release released;
  std::string text = engine.answer(request, caller);
  return text;
}

}  // namespace

PYBIND11_MODULE(_engine, module) {
  module.doc() = "The calls of the protocol, answered in this process.";
  module.attr("__version__") = SELVAGE_VERSION;
  py::class_<std::stop_source>(module, "Stop", "Stops the calls that it was passed to.")
      .def(py::init<>())
      .def("request", [](std::stop_source& stop) { stop.request_stop(); });
  py::class_<Engine>(module, "Engine", "Holds open markers and answers the calls of the protocol on them.")
      .def(py::init([](std::size_t threads) { return std::make_unique<Engine>(std::max<std::size_t>(threads, 1)); }),
           py::arg("threads") = 1)
      .def("answer", &answer, py::arg("request"), py::arg("stop"), py::arg("on_round") = py::none(),
           "Returns the response to a JSON-RPC request as text.  Calls on_round(round, length, bound, nodes) on this "
           "thread.");
}
