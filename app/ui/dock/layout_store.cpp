#include "app/ui/dock/layout_store.h"

#include <QSettings>

namespace app {

namespace {

QString railKey(const QString &key)
{
    return key + "Rail";
}

QString lengthKey(const QString &key, const QString &name)
{
    return key + "Length/" + name;
}

}

QByteArray LayoutStore::layout(const QString &key) const
{
    const auto found = m_stored.find(key);
    return found != m_stored.end() ? found->second : QSettings().value(key).toByteArray();
}

void LayoutStore::forget(const QString &key)
{
    m_stored.erase(key);
    QSettings().remove(key);
    QSettings().remove(railKey(key));
    QSettings().remove(lengthKey(key, {}).chopped(1)); // the group with all lengths
}

void LayoutStore::save() const
{
    QSettings settings;
    for (const auto &[key, state] : m_stored)
        settings.setValue(key, state);
}

bool LayoutStore::hasRail(const QString &key, bool byItself) const
{
    return QSettings().value(railKey(key), byItself).toBool();
}

int LayoutStore::length(const QString &key, const QString &name, int byItself) const
{
    return QSettings().value(lengthKey(key, name), byItself).toInt();
}

void LayoutStore::chooseLength(const QString &key, const QString &name, int px)
{
    QSettings().setValue(lengthKey(key, name), px);
}

void LayoutStore::chooseRail(const QString &key, bool rail)
{
    QSettings().setValue(railKey(key), rail);
}

}
