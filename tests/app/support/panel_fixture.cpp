#include "tests/app/support/panel_fixture.h"

#include <QTest>

using namespace app;

namespace tests {

void show(QWidget &widget, QSize size)
{
    widget.resize(size);
    widget.show();
    QVERIFY(QTest::qWaitForWindowActive(&widget));
}

ParameterRow *rowOf(const ParameterPanel &panel, const QString &id)
{
    for (ParameterRow *row : panel.findChildren<ParameterRow *>()) {
        if (row->parameter().id == id)
            return row;
    }
    return nullptr;
}

}
