#include "app/model/learning/proofs.h"

#include <QCoreApplication>
#include <QSettings>
#include <QStringList>

namespace app {

namespace {

constexpr qsizetype proofFields = 7;

QStringList fieldsOf(const Proof &proof)
{
    return {proof.when.toString(Qt::ISODate),
            proof.run,
            QString::number(proof.at.frame),
            QString::number(proof.at.phase),
            proof.beside,
            QString::number(proof.fork),
            proof.code};
}

}

Proofs::Proofs() = default;
Proofs::~Proofs() = default;

QSettings &Proofs::settings() const
{
    if (!m_settings)
        m_settings =
            std::make_unique<QSettings>(QSettings::defaultFormat(), QSettings::UserScope,
                                        QCoreApplication::organizationName(), QStringLiteral("notebook"));
    return *m_settings;
}

bool Proofs::has(const QString &key) const
{
    return settings().contains(key);
}

std::optional<Proof> Proofs::find(const QString &key) const
{
    const QStringList fields = settings().value(key).toStringList();
    if (fields.size() != proofFields) // none, or from another version of the program
        return std::nullopt;
    return Proof{.run = fields[1],
                 .at = {fields[2].toLongLong(), fields[3].toInt()},
                 .beside = fields[4],
                 .fork = fields[5].toLongLong(),
                 .code = fields[6],
                 .when = QDateTime::fromString(fields[0], Qt::ISODate)};
}

void Proofs::keep(const QString &key, Proof proof)
{
    if (proof.run.size() + proof.beside.size() + proof.code.size() > longest)
        return;
    if (!proof.when.isValid())
        proof.when = QDateTime::currentDateTimeUtc();
    settings().setValue(key, fieldsOf(proof));
}

}
