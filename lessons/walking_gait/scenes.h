#pragma once

#include "sim/forward.h"

/// One scene per step (see lessons/README.md). The feet are points 0, 1, 2... and the body is the last point.
namespace walking_gait {

namespace bones {
sim::Scene setUp(const sim::Values &values);
}
namespace legs {
sim::Scene setUp(const sim::Values &values);
}
namespace feet_below {
sim::Scene setUp(const sim::Values &values);
}
namespace curved_legs {
sim::Scene setUp(const sim::Values &values);
}
namespace swing {
sim::Scene setUp(const sim::Values &values);
}
namespace body_pulled {
sim::Scene setUp(const sim::Values &values);
}
namespace ground {
sim::Scene setUp(const sim::Values &values);
}
namespace more_feet {
sim::Scene setUp(const sim::Values &values);
}
namespace steering {
sim::Scene setUp(const sim::Values &values);
}
namespace walls {
sim::Scene setUp(const sim::Values &values);
}
namespace company {
/// Returns `count` creatures with two feet each that walk towards the middle.
sim::Scene inARow(int count, double speed);
sim::Scene setUp(const sim::Values &values);
}

}
