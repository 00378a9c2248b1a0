// The labs, one folder each.
#pragma once

#include "labs/framework/lab.h"

namespace glassbox::labs {

Lab lab_01();
Lab lab_02();
Lab lab_03();

}  // namespace glassbox::labs
