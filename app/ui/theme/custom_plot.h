#pragma once

// qcustomplot.h includes all of QtPrintSupport, and with it all Qt headers, but needs none of it. Without
// this macro a file that includes it takes four seconds to compile; with it, one second.
#define QT_QTPRINTSUPPORT_MODULE_H

#include <QWidget>
#include <qcustomplot.h>
