#pragma once

// qcustomplot.h asks for all of QtPrintSupport, which asks for all of Qt's headers, and needs none of it: a file that
// includes it takes four seconds to compile, and one second this way.
#define QT_QTPRINTSUPPORT_MODULE_H

#include <QWidget>
#include <qcustomplot.h>
