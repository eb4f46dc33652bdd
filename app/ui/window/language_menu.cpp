// The choice of the window's language.

#include "app/model/language.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/notice.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QSettings>

namespace app {

void MainWindow::makeLanguageMenu()
{
    QMenu *menu = m_view->addMenu(tr("Lan&guage"));
    menu->setObjectName("language");
    auto *group = new QActionGroup(menu);
    const QString chosen = QSettings().value("window/language").toString();
    const QString spoken = Language::chosen(chosen);
    const auto add = [&](const QString &text, const QString &code) {
        QAction *made = menu->addAction(text);
        made->setCheckable(true);
        made->setChecked(code == chosen);
        made->setData(code);
        group->addAction(made);
        connect(made, &QAction::triggered, this, [this, code, spoken] { chooseLanguage(code, spoken); });
    };
    add(tr("As the &system has it"), {});
    menu->addSeparator();
    for (const QString &code : Language::known())
        add(Language::nameOf(code), code);
}

void MainWindow::chooseLanguage(const QString &code, const QString &spoken)
{
    QSettings().setValue("window/language", code);
    const QString next = Language::chosen(code);
    if (next == spoken)
        m_notice->say({}); // as it is
    else
        startAgainFor(tr("Springstep speaks %1 from its next start on.").arg(Language::nameOf(next)));
}

}
