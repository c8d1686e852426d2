#include "devices/capture/angle_plan.h"
