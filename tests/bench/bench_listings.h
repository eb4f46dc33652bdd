#pragma once

namespace bench {

/// Registers two benchmarks for each step that has a listing: "listing/LESSON/STEP" and "listing_compiled/LESSON/STEP".
/// @throws std::runtime_error if a lesson does not load, or its listing does not compile
void addListings();

}
