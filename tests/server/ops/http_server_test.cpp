// Holds the small HTTP server against requests that are good, wrong, endless, or too many.
#include "server/ops/http_server.h"

#include "tests/server/net/raw_client.h"

#include <future>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace billiards::server {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Running {
  public:
    explicit Running(const HttpLimits& limits = {})
        : server_(
              context_, *parse_endpoint("127.0.0.1:0"),
              [this](const std::string& path, HttpRespond respond) {
                  answer(path, std::move(respond));
              },
              log_, limits) {
        server_.start();
        thread_ = std::thread([this] { context_.run(); });
    }
    ~Running() {
        context_.stop();
        thread_.join();
    }

    std::string ask(std::string_view request) {
        RawClient client(port());
        client.send(request);
        return text_of(client.receive_all());
    }
    static std::string text_of(const RawClient::Bytes& bytes) {
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }
    std::uint16_t port() const { return server_.endpoint().port(); }

    /// Answers to /later, from a thread that is not the server's.
    void answer_later() { later_.get_future().get()({.status = 503, .body = "late\n"}); }

  private:
    void answer(const std::string& path, HttpRespond respond) {
        if (path == "/later") return later_.set_value(std::move(respond));
        if (path == "/never") return;
        respond({.status = path == "/page" ? 200 : 404, .body = "path " + path + "\n"});
    }

    std::promise<HttpRespond> later_;
    spdlog::logger log_{"test"};
    asio::io_context context_{1};
    HttpServer server_;
    std::thread thread_;
};

TEST(HttpServer, AnswersAGet) {
    Running running;
    EXPECT_EQ(running.ask("GET /page HTTP/1.1\r\nHost: a\r\n\r\n"),
              "HTTP/1.1 200 OK\r\nContent-Type: text/plain; charset=utf-8\r\nContent-Length: 11\r\n"
              "Connection: close\r\n\r\npath /page\n");
}

TEST(HttpServer, LeavesOutTheBodyForAHead) {
    Running running;
    EXPECT_THAT(running.ask("HEAD /page HTTP/1.1\r\n\r\n"),
                AllOf(StartsWith("HTTP/1.1 200 OK"), HasSubstr("Content-Length: 11"),
                      Not(HasSubstr("path"))));
}

TEST(HttpServer, TakesTheQueryOffThePath) {
    Running running;
    EXPECT_THAT(running.ask("GET /page?a=b HTTP/1.1\r\n\r\n"), EndsWith("path /page\n"));
}

TEST(HttpServer, PassesOnTheStatusOfTheHandler) {
    Running running;
    EXPECT_THAT(running.ask("GET /nowhere HTTP/1.1\r\n\r\n"), StartsWith("HTTP/1.1 404 Not Found"));
}

TEST(HttpServer, TakesAnAnswerFromAnotherThread) {
    Running running;
    RawClient client(running.port());
    client.send("GET /later HTTP/1.1\r\n\r\n");
    running.answer_later();
    EXPECT_THAT(Running::text_of(client.receive_all()),
                AllOf(StartsWith("HTTP/1.1 503 Service Unavailable"), EndsWith("late\n")));
}

TEST(HttpServer, RefusesOtherMethods) {
    Running running;
    EXPECT_THAT(running.ask("POST /page HTTP/1.1\r\n\r\n"), StartsWith("HTTP/1.1 405 "));
}

TEST(HttpServer, RefusesWhatIsNoRequest) {
    Running running;
    for (const char* request : {"\r\n\r\n", "GET\r\n\r\n", "GET /page\r\n\r\n", " \r\n\r\n",
                                "GET /page FTP/1.1\r\n\r\n", "GLBILLRD\x01\r\n\r\n"}) {
        EXPECT_THAT(running.ask(request), StartsWith("HTTP/1.1 400 ")) << request;
    }
}

TEST(HttpServer, RefusesARequestThatIsTooLong) {
    Running running({.request_bytes = 64});
    EXPECT_THAT(running.ask(std::string(64, 'x')), StartsWith("HTTP/1.1 400 "));
}

TEST(HttpServer, CutsOffARequestThatDoesNotEnd) {
    Running running({.timeout = 30ms});
    EXPECT_EQ(running.ask("GET /page HTTP/1.1\r\n"), "");
}

TEST(HttpServer, CutsOffAClientWhoseAnswerDoesNotCome) {
    Running running({.timeout = 30ms});
    EXPECT_EQ(running.ask("GET /never HTTP/1.1\r\n\r\n"), "");
}

TEST(HttpServer, ClosesConnectionsBeyondItsLimitAndGoesOn) {
    Running running({.connections = 2});
    std::optional<RawClient> first(std::in_place, running.port());
    RawClient second(running.port());
    RawClient third(running.port());
    EXPECT_TRUE(third.is_closed_by_other_side());
    first->send("GET /page HTTP/1.1\r\n\r\n");
    EXPECT_THAT(Running::text_of(first->receive_all()), EndsWith("path /page\n"));
    EXPECT_THAT(running.ask("GET /page HTTP/1.1\r\n\r\n"), EndsWith("path /page\n"));
}

}  // namespace
}  // namespace billiards::server
