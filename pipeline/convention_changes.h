#pragma once
#include <glassbox/pipeline/matrices/slips.h>
