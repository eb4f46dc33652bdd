#pragma once

#include "app/model/catalog/lesson_library.h"
#include "app/model/session/session.h"
#include "app/ui/code/engine/code_panel.h"
#include "app/ui/code/engine/code_view.h"
#include "app/ui/theme/theme.h"
#include "tests/app/code/listing_support.h"

#include <QSettings>
#include <QTest>

#include <algorithm>

/// Shared by the suites of the code panel.
namespace code_support {

using namespace app;

using listing_support::library;

/// Says whether the settings of an earlier window are kept.
enum class Settings { fresh, kept };

/// The code panel in a window of its own.
struct CodeFixture
{
    explicit CodeFixture(const QString &lesson = "multi_foot", const QString &step = "any_number",
                         Settings settings = Settings::fresh)
    {
        if (settings == Settings::fresh)
            QSettings().remove(CodeView::foldedKey);
        session.openStep(lesson, step);
        window.resize(480, 600);
        panel = new CodePanel(session, theme, &window);
        panel->resize(window.size());
        panel->titleActions()->setParent(&window);
        window.show();
        window.activateWindow();
    }
    CodeView &view() { return panel->view(); }

    std::size_t row(const QString &part, CodeRow::Kind kind = CodeRow::Kind::code)
    {
        const auto &rows = view().rows();
        const auto found = std::find_if(rows.begin(), rows.end(), [&](const CodeRow &one) {
            return one.kind == kind && one.text.contains(part);
        });
        return static_cast<std::size_t>(found - rows.begin());
    }
    std::size_t heading(const QString &part) { return row(part, CodeRow::Kind::heading); }
    std::size_t sectionOf(std::size_t atRow) { return view().rows()[atRow].section; }

    void click(std::size_t atRow)
    {
        QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, view().rowRect(atRow).center());
    }
    QToolButton *button(const QString &accessible)
    {
        for (QToolButton *one : panel->titleActions()->findChildren<QToolButton *>()) {
            if (one->accessibleName().contains(accessible))
                return one;
        }
        return nullptr;
    }
    /// The colour of the viewport at the very right of a row.
    QColor colorOf(std::size_t atRow)
    {
        const QImage image = view().viewport()->grab().toImage();
        const QRect rect = view().rowRect(atRow);
        return image.pixelColor(rect.right() - 1, rect.center().y());
    }

    Session session{library()};
    Theme theme{Scheme::light};
    QWidget window;
    CodePanel *panel = nullptr;
};

}
