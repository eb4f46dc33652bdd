#pragma once

#include "app/ui/settings/appearance.h"
#include "tests/app/support/window_fixture.h"

namespace keyboard_support {

using namespace app;

/// The window at 1920 x 1080 px, in the colours that the settings have.
struct LargeWindow : tests::WindowFixture
{
    explicit LargeWindow(const char *lesson = "gravity_walls", const char *step = "gravity")
        : WindowFixture({.lesson = lesson, .step = step, .size = {1920, 1080}, .scheme = storedScheme()})
    {
    }
};

}
