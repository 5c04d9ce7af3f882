// Gives the tests of one suite one window, with two players at its table: opening one for each
// would take longer than what they look at.
#pragma once

#include "tests/client/window/test_window.h"

#include <gtest/gtest.h>
#include <memory>

namespace billiards::client {

class SharedWindow : public testing::Test {
  public:
    static void SetUpTestSuite() {
        shared_ = std::make_unique<TestWindow>();
        sit_down(*shared_);
    }
    static void TearDownTestSuite() { shared_.reset(); }

  protected:
    TestWindow& window_ = *shared_;

  private:
    inline static std::unique_ptr<TestWindow> shared_;
};

}  // namespace billiards::client
