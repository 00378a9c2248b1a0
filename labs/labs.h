// The labs, one folder each.
#pragma once

#include "labs/framework/lab.h"

namespace glassbox::labs {

Lab lab_01();
Lab lab_02();
Lab lab_03();
Lab lab_04();
Lab lab_05();
Lab lab_06();
Lab lab_07();
Lab lab_08();
Lab lab_09();

}  // namespace glassbox::labs
