// Takes GET requests for a few small pages; gives them to a handler, and its answers back.
#pragma once

#include "server/net/listener.h"

#include <asio/io_context.hpp>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <spdlog/logger.h>
#include <string>

namespace billiards::server {

struct HttpResponse {
    int status = 200;
    std::string content_type = "text/plain; charset=utf-8";
    std::string body;
};

/// Answers once, from any thread; not at all means that the client is cut off in time.
using HttpRespond = std::function<void(HttpResponse)>;
/// Takes the path without its query. Called on the thread that runs the io_context.
using HttpHandler = std::function<void(const std::string& path, HttpRespond respond)>;

struct HttpLimits {
    std::size_t connections = 16;
    std::size_t request_bytes = 4096;
    std::chrono::milliseconds timeout = std::chrono::seconds(5);  ///< For a whole exchange.
};

/// As much of HTTP/1.1 as a probe and a scraper of metrics ask for: GET and HEAD, one request a
/// connection. Lives on the thread that runs the io_context.
class HttpServer {
  public:
    /// Throws as Listener does.
    HttpServer(asio::io_context& context, const Endpoint& endpoint, HttpHandler handler,
               spdlog::logger& log, const HttpLimits& limits = {});

    Endpoint endpoint() const { return listener_.endpoint(); }
    void start();

  private:
    void accepted(Socket socket);

    const HttpLimits limits_;
    const HttpHandler handler_;
    Listener listener_;
    std::shared_ptr<std::size_t> open_ = std::make_shared<std::size_t>(0);
};

}  // namespace billiards::server
