#include "app/gui/steps/model_chooser.h"

#include "app/gui/figures/figure_parts.h"
#include "core/angle/model_limits.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

namespace straightedge::gui {

using angle::FitMethod;
using angle::ModelKind;

namespace {

struct MethodChoice {
  FitMethod method;
  const char* text;
  const char* tip;
};

QList<MethodChoice> methodsOf(ModelKind kind) {
  switch (kind) {
  case ModelKind::Harmonic:
    return {{FitMethod::ByAmplitude, QT_TRANSLATE_NOOP("ModelChooser", "largest first"),
             QT_TRANSLATE_NOOP("ModelChooser", "The harmonics with the largest amplitudes, whatever their order")},
            {FitMethod::Ordered, QT_TRANSLATE_NOOP("ModelChooser", "in order"),
             QT_TRANSLATE_NOOP("ModelChooser", "Harmonics 1, 2, 3, …")}};
  case ModelKind::Linear:
    return {{FitMethod::LeastSquares, QT_TRANSLATE_NOOP("ModelChooser", "least squares"),
             QT_TRANSLATE_NOOP("ModelChooser", "Smallest mean square error")},
            {FitMethod::OnCurve, QT_TRANSLATE_NOOP("ModelChooser", "on the curve"),
             QT_TRANSLATE_NOOP("ModelChooser", "Values taken on the correction curve")},
            {FitMethod::Minimax, QT_TRANSLATE_NOOP("ModelChooser", "minimax"),
             QT_TRANSLATE_NOOP("ModelChooser", "Smallest possible maximum error")}};
  case ModelKind::LookupTable:
    return {{FitMethod::Mean, QT_TRANSLATE_NOOP("ModelChooser", "mean"),
             QT_TRANSLATE_NOOP("ModelChooser", "Mean of each bin: smallest mean square error")},
            {FitMethod::MidRange, QT_TRANSLATE_NOOP("ModelChooser", "mid-range"),
             QT_TRANSLATE_NOOP("ModelChooser", "Middle between smallest and largest of each bin: smallest maximum")}};
  }
  return {};
}

} // namespace

ModelChooser::ModelChooser(std::function<QString(const angle::ModelName&)> problemOf, QWidget* parent)
    : QWidget(parent), m_problemOf(std::move(problemOf)), m_kind(new QComboBox(this)), m_size(new QSpinBox(this)),
      m_method(new QComboBox(this)), m_bits(new QComboBox(this)), m_cost(new QLabel(this)),
      m_add(new QPushButton(tr("&Add model"), this)) {
  m_kind->setObjectName(QStringLiteral("modelKind"));
  m_size->setObjectName(QStringLiteral("modelSize"));
  m_method->setObjectName(QStringLiteral("modelMethod"));
  m_bits->setObjectName(QStringLiteral("modelBits"));
  m_add->setObjectName(QStringLiteral("addModel"));
  m_cost->setObjectName(QStringLiteral("modelCost"));
  m_kind->addItem(tr("Harmonics"), static_cast<int>(ModelKind::Harmonic));
  m_kind->addItem(tr("Linear segments"), static_cast<int>(ModelKind::Linear));
  m_kind->addItem(tr("Lookup table"), static_cast<int>(ModelKind::LookupTable));
  m_bits->addItem(tr("float, 4 bytes"), 0);
  for (int bits = angle::largestBits; bits >= angle::smallestBits; --bits) {
    m_bits->addItem(tr("integers, %1 bit").arg(bits), bits);
  }
  m_cost->setWordWrap(true);

  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("&Kind"), m_kind);
  form->addRow(tr("&Size"), m_size);
  form->addRow(tr("&Method"), m_method);
  form->addRow(tr("Stored &as"), m_bits);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(form);
  layout->addWidget(m_cost);
  layout->addWidget(m_add);

  connect(m_kind, &QComboBox::currentIndexChanged, this, [this] {
    fillMethods();
    refresh();
  });
  connect(m_size, &QSpinBox::valueChanged, this, &ModelChooser::refresh);
  connect(m_method, &QComboBox::currentIndexChanged, this, &ModelChooser::refresh);
  connect(m_bits, &QComboBox::currentIndexChanged, this, &ModelChooser::refresh);
  connect(m_add, &QPushButton::clicked, this, [this] { emit addRequested(name()); });
  setName({.kind = ModelKind::Linear, .size = 64, .method = FitMethod::LeastSquares, .bits = {}});
}

angle::ModelName ModelChooser::name() const {
  angle::ModelName name;
  name.kind = static_cast<ModelKind>(m_kind->currentData().toInt());
  name.size = m_size->value();
  name.method = static_cast<FitMethod>(m_method->currentData().toInt());
  if (const int bits = m_bits->currentData().toInt(); bits > 0) {
    name.bits = bits;
  }
  return name;
}

void ModelChooser::setName(const angle::ModelName& name) {
  {
    const QSignalBlocker quiet(m_kind);
    m_kind->setCurrentIndex(m_kind->findData(static_cast<int>(name.kind)));
  }
  fillMethods();
  m_size->setValue(name.size);
  m_method->setCurrentIndex(m_method->findData(static_cast<int>(name.method)));
  m_bits->setCurrentIndex(m_bits->findData(name.bits.value_or(0)));
  refresh();
}

void ModelChooser::refresh() {
  const angle::ModelName chosen = name();
  const QString problem = m_problemOf ? m_problemOf(chosen) : QString();
  m_add->setEnabled(problem.isEmpty());
  m_cost->setText(problem.isEmpty() ? tr("%1: %2 entries, %3 bytes")
                                          .arg(modelNameText(chosen))
                                          .arg(chosen.storageEntries())
                                          .arg(chosen.storageBytes())
                                    : problem);
}

void ModelChooser::fillMethods() {
  const auto kind = static_cast<ModelKind>(m_kind->currentData().toInt());
  const angle::SizeRange range = angle::sizeRange(kind);
  const QSignalBlocker quietSize(m_size);
  const QSignalBlocker quietMethod(m_method);
  m_size->setRange(range.smallest, range.largest);
  m_size->setSuffix(kind == ModelKind::Harmonic ? tr(" harmonics")
                    : kind == ModelKind::Linear ? tr(" segments")
                                                : tr(" entries"));
  m_method->clear();
  for (const MethodChoice& choice : methodsOf(kind)) {
    m_method->addItem(tr(choice.text), static_cast<int>(choice.method));
    m_method->setItemData(m_method->count() - 1, tr(choice.tip), Qt::ToolTipRole);
  }
}

} // namespace straightedge::gui
