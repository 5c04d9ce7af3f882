// Takes a term of the rules; gives what people call it.
#pragma once

#include "common/rules/verdict.h"

#include <string>

namespace billiards::client {

std::string words(rules::Foul foul);
std::string words(rules::Choice choice);
std::string words(rules::Group group);

}  // namespace billiards::client
