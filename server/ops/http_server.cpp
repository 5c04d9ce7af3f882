// Takes GET requests for a few small pages; gives them to a handler, and its answers back.
#include "server/ops/http_server.h"

#include <asio/buffer.hpp>
#include <asio/post.hpp>
#include <asio/read_until.hpp>
#include <asio/write.hpp>
#include <fmt/format.h>
#include <optional>
#include <string_view>
#include <utility>

namespace billiards::server {
namespace {

constexpr std::chrono::milliseconds kPauseWhenOutOfSockets{1000};

struct Request {
    std::string method;
    std::string path;  ///< Without its query.
};

/// From "GET /path?query HTTP/1.1".
std::optional<Request> parse_request_line(std::string_view line) {
    const std::size_t first = line.find(' ');
    const std::size_t second = line.find(' ', first + 1);
    if (first == std::string_view::npos || second == std::string_view::npos) return std::nullopt;
    if (!line.substr(second + 1).starts_with("HTTP/1.")) return std::nullopt;
    const std::string_view target = line.substr(first + 1, second - first - 1);
    return Request{std::string(line.substr(0, first)),
                   std::string(target.substr(0, target.find('?')))};
}

std::string_view reason_of(int status) {
    switch (status) {
        case 200:
            return "OK";
        case 400:
            return "Bad Request";
        case 404:
            return "Not Found";
        case 405:
            return "Method Not Allowed";
        case 503:
            return "Service Unavailable";
        default:
            return "Unknown";
    }
}

std::string to_text(const HttpResponse& response, bool with_body) {
    return fmt::format(
        "HTTP/1.1 {} {}\r\nContent-Type: {}\r\nContent-Length: {}\r\nConnection: close\r\n\r\n{}",
        response.status, reason_of(response.status), response.content_type, response.body.size(),
        with_body ? response.body : "");
}

/// One connection: one request, one answer, one timeout. Ends on the thread of its socket.
class Exchange : public std::enable_shared_from_this<Exchange> {
  public:
    Exchange(Socket socket, const HttpLimits& limits, const HttpHandler& handler,
             std::shared_ptr<std::size_t> open)
        : socket_(std::move(socket)),
          timeout_(socket_.get_executor()),
          limits_(limits),
          handler_(handler),
          open_(std::move(open)) {
        ++*open_;
    }
    ~Exchange() { --*open_; }
    Exchange(const Exchange&) = delete;
    Exchange& operator=(const Exchange&) = delete;

    void start() {
        timeout_.expires_after(limits_.timeout);
        timeout_.async_wait([self = shared_from_this()](const asio::error_code& cancelled) {
            if (!cancelled) self->close();
        });
        asio::async_read_until(
            socket_, asio::dynamic_buffer(head_, limits_.request_bytes), "\r\n\r\n",
            [self = shared_from_this()](const asio::error_code& error, std::size_t) {
                // "Not found" is the end of a request that is too long.
                if (error && error != asio::error::not_found) return self->close();
                self->answer();
            });
    }

  private:
    void answer() {
        const auto request = parse_request_line(head_.substr(0, head_.find("\r\n")));
        if (!request) return write({.status = 400, .body = "bad request\n"}, true);
        const bool with_body = request->method != "HEAD";
        if (with_body && request->method != "GET") {
            return write({.status = 405, .body = "only GET and HEAD\n"}, true);
        }
        // Whoever answers on another thread must not be the last to hold this: the timeout does.
        handler_(request->path, [executor = socket_.get_executor(), weak = weak_from_this(),
                                 with_body](HttpResponse response) {
            asio::post(executor, [weak, with_body, response = std::move(response)] {
                if (const auto self = weak.lock()) self->write(response, with_body);
            });
        });
    }

    void write(const HttpResponse& response, bool with_body) {
        answer_ = to_text(response, with_body);
        asio::async_write(
            socket_, asio::buffer(answer_),
            [self = shared_from_this()](const asio::error_code&, std::size_t) { self->close(); });
    }

    void close() {
        asio::error_code ignored;
        socket_.shutdown(Socket::shutdown_send, ignored);
        socket_.close(ignored);
        timeout_.cancel();
    }

    Socket socket_;
    asio::steady_timer timeout_;
    const HttpLimits limits_;
    const HttpHandler handler_;
    std::shared_ptr<std::size_t> open_;
    std::string head_;
    std::string answer_;
};

}  // namespace

HttpServer::HttpServer(asio::io_context& context, const Endpoint& endpoint, HttpHandler handler,
                       spdlog::logger& log, const HttpLimits& limits)
    : limits_(limits),
      handler_(std::move(handler)),
      listener_(context, endpoint, log, kPauseWhenOutOfSockets) {}

void HttpServer::start() {
    listener_.start([this](Socket socket) { accepted(std::move(socket)); });
}

void HttpServer::accepted(Socket socket) {
    if (*open_ >= limits_.connections) return;
    std::make_shared<Exchange>(std::move(socket), limits_, handler_, open_)->start();
}

}  // namespace billiards::server
