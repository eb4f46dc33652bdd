#pragma once

namespace app {

/// `springstep lessons`: lists lessons, steps, parameters and methods, for people or as JSON. Returns the exit
/// code.
int listLessons(bool asJson);

}
