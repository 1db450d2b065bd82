#include "net/connect.h"

#include <gtest/gtest.h>
