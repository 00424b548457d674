#pragma once

#include <gtest/gtest.h>

#include <string>

/// Expects that a message contains these words, and shows it where it does not.
#define EXPECT_SAYS(message, words) EXPECT_NE((message).find(words), std::string::npos) << (message)
