#include "app/ui/settings/language_menu.h"

#include "app/model/text/language.h"

#include <QActionGroup>
#include <QSettings>

namespace app {

namespace {

constexpr const char *languageKey = "window/language";

}

LanguageMenu::LanguageMenu(QWidget *parent)
    : QMenu(tr("Lan&guage"), parent), m_chosen(QSettings().value(languageKey).toString()),
      m_current(Language::chosen(m_chosen)), m_group(new QActionGroup(this))
{
    setObjectName("language");
    add(tr("&System language"), {});
    addSeparator();
    for (const QString &code : Language::known())
        add(Language::nameOf(code), code);
}

void LanguageMenu::add(const QString &text, const QString &code)
{
    QAction *entry = addAction(text);
    entry->setCheckable(true);
    entry->setChecked(code == m_chosen);
    entry->setData(code);
    m_group->addAction(entry);
    connect(entry, &QAction::triggered, this, [this, code] { choose(code); });
}

void LanguageMenu::choose(const QString &code)
{
    QSettings().setValue(languageKey, code);
    const QString next = Language::chosen(code);
    if (next == m_current)
        emit unchanged();
    else
        emit restartWanted(tr("Springstep will use %1 after a restart.").arg(Language::nameOf(next)));
}

}
