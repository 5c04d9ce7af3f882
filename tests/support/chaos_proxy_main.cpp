// Takes a server's address, a seed and a preset; gives a port on 127.0.0.1 behind which the same
// server is hard to reach, until SIGINT or SIGTERM.
#include "tests/support/chaos_proxy.h"

#include <CLI/CLI.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/signal_set.hpp>
#include <cstdint>
#include <exception>
#include <iostream>
#include <string>

namespace {

using billiards::support::ChaosProxy;

struct Arguments {
    std::uint16_t listen_port = 0;
    std::string host = "127.0.0.1";
    std::uint16_t target_port = 0;
    std::uint64_t seed = 1;
    std::string preset = "mild";
};

void wait_for_a_signal() {
    asio::io_context context;
    asio::signal_set signals(context, SIGINT, SIGTERM);
    signals.async_wait([](const asio::error_code&, int) {});
    context.run();
}

void run(const Arguments& arguments) {
    const auto settings = billiards::support::chaos_preset(arguments.preset);
    ChaosProxy proxy({asio::ip::make_address(arguments.host), arguments.target_port},
                     settings.value(), arguments.seed, arguments.listen_port);
    std::cout << "listening on 127.0.0.1:" << proxy.port() << std::endl;
    wait_for_a_signal();
    proxy.stop();
    const billiards::support::ChaosCounts counts = proxy.counts();
    std::cout << counts.connections << " connections, " << counts.bytes << " bytes, "
              << counts.splits << " splits, " << counts.stalls << " stalls, " << counts.resets
              << " resets" << std::endl;
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app{"A network that does not behave, between clients and a server"};
    app.add_option("--listen", arguments.listen_port, "Port on 127.0.0.1; 0 takes a free one");
    app.add_option("--target-host", arguments.host, "The server's address")->capture_default_str();
    app.add_option("--target", arguments.target_port, "The server's port")->required();
    app.add_option("--seed", arguments.seed, "What goes wrong")->capture_default_str();
    app.add_option("--preset", arguments.preset, "How much goes wrong")
        ->check(CLI::IsMember({"none", "mild", "worst"}))
        ->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        run(arguments);
    } catch (const std::exception& exception) {
        std::cerr << "chaos-proxy: " << exception.what() << '\n';
        return 1;
    }
    return 0;
}
