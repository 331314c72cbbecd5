#include "base/log.h"

#include <spdlog/sinks/stdout_sinks.h>

#include <cstdlib>

namespace idap {

void setUpLogging() {
  auto logger = std::make_shared<spdlog::logger>("idap", std::make_shared<spdlog::sinks::stderr_sink_mt>());
  logger->set_pattern("idap: %l: %v");
  const char* level = std::getenv("IDAP_LOG");
  logger->set_level(level ? spdlog::level::from_str(level) : spdlog::level::warn);
  spdlog::set_default_logger(std::move(logger));
}

}  // namespace idap
