#pragma once

#include "sim/pipeline/method.h"
#include "tests/sim/support/support.h"

#include <QTest>

namespace support {

/// Adds one test row per method with a fixed step, with the column "method".
inline void addFixedMethodRows()
{
    QTest::addColumn<QString>("method");
    for (const sim::MethodPtr &method : fixedMethods())
        QTest::newRow(method->id().c_str()) << QString::fromStdString(method->id());
}

}
