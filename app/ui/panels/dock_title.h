#pragma once

#include "app/ui/panels/panel_title.h"
