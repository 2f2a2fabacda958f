#include "ros_interface/panel/repertoire_tab.h"

#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/pose2.h"

namespace hexapod {
namespace {

constexpr double kMostError_deg = 180.0;
constexpr double kMostSpread_cm = 1000.0;
constexpr int kColumnWidth = 58;

// A box whose largest value lets all pass.
QDoubleSpinBox* limitBox(const char* name, double most, QWidget* parent) {
  auto* box = new QDoubleSpinBox(parent);
  box->setObjectName(name);
  box->setRange(0.0, most);
  box->setValue(most);
  box->setSingleStep(0.5);
  box->setKeyboardTracking(false);
  return box;
}

double limitOf(const QDoubleSpinBox& box, double unit) {
  if (box.value() >= box.maximum()) return std::numeric_limits<double>::infinity();
  return box.value() * unit;
}

}  // namespace

RepertoireTab::RepertoireTab(Orders orders, QWidget* parent)
    : QWidget(parent),
      orders_(std::move(orders)),
      file_(new QLineEdit(this)),
      load_(new QPushButton("Load", this)),
      max_error_deg_(limitBox("max_error_deg", kMostError_deg, this)),
      max_spread_cm_(limitBox("max_spread_cm", kMostSpread_cm, this)),
      words_(new QLabel(this)),
      entries_(new EntryTable(this)),
      sorted_(new QSortFilterProxyModel(this)),
      table_(new QTableView(this)) {
  words_->setWordWrap(true);
  words_->setObjectName("repertoire_words");
  makeTable();
  auto* column = new QVBoxLayout(this);
  column->addWidget(makeFileRow());
  column->addWidget(makeFilterRow());
  column->addWidget(words_);
  column->addWidget(table_, 1);
}

QWidget* RepertoireTab::makeFileRow() {
  auto* widget = new QWidget(this);
  auto* row = new QHBoxLayout(widget);
  row->setContentsMargins(0, 0, 0, 0);
  auto* browse = new QPushButton("...", widget);
  file_->setObjectName("file");
  file_->setPlaceholderText("newest");
  file_->setToolTip("File of a repertoire; empty: the newest of ~/.ros");
  load_->setObjectName("load");
  browse->setMaximumWidth(30);
  connect(browse, &QPushButton::clicked, [this] {
    const QString chosen =
        QFileDialog::getOpenFileName(this, "A repertoire", file_->text(), "Repertoires (*.db)");
    if (!chosen.isEmpty()) file_->setText(chosen);
  });
  connect(load_, &QPushButton::clicked,
          [this] { orders_.load(file_->text().trimmed().toStdString()); });
  row->addWidget(file_, 1);
  row->addWidget(browse);
  row->addWidget(load_);
  return widget;
}

QWidget* RepertoireTab::makeFilterRow() {
  auto* widget = new QWidget(this);
  auto* form = new QFormLayout(widget);
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow("error up to [deg]", max_error_deg_);
  form->addRow("spread up to [cm]", max_spread_cm_);
  for (QDoubleSpinBox* box : {max_error_deg_, max_spread_cm_}) {
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged),
            [this] { orders_.filter(filter()); });
  }
  return widget;
}

void RepertoireTab::makeTable() {
  sorted_->setSourceModel(entries_);
  sorted_->setSortRole(Qt::UserRole);
  table_->setObjectName("entries");
  table_->setModel(sorted_);
  table_->setSortingEnabled(true);
  table_->sortByColumn(0, Qt::AscendingOrder);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setDefaultSectionSize(kColumnWidth);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setToolTip("A click shows the entry in rviz, two clicks play it");
  connect(table_, &QTableView::clicked,
          [this](const QModelIndex& index) { chooseAt(index, false); });
  connect(table_, &QTableView::doubleClicked,
          [this](const QModelIndex& index) { chooseAt(index, true); });
}

void RepertoireTab::chooseAt(const QModelIndex& index, bool play) {
  orders_.choose(entries_->idAt(sorted_->mapToSource(index).row()), play);
}

EntryFilter RepertoireTab::filter() const {
  return {limitOf(*max_error_deg_, kDegree), limitOf(*max_spread_cm_, 0.01)};
}

void RepertoireTab::show(const PanelModel& model) {
  load_->setEnabled(model.offers(Ask::kLoad));
  words_->setText(QString::fromStdString(model.repertoireSentence()));
  if (shown_revision_ == model.entriesRevision()) return;
  shown_revision_ = model.entriesRevision();
  entries_->show(model.entries());
}

void RepertoireTab::save(rviz::Config config) const {
  config.mapSetValue("Repertoire File", file_->text());
  config.mapSetValue("Largest Error", max_error_deg_->value());
  config.mapSetValue("Largest Spread", max_spread_cm_->value());
}

void RepertoireTab::load(const rviz::Config& config) {
  QString file;
  if (config.mapGetString("Repertoire File", &file)) file_->setText(file);
  QVariant value;
  if (config.mapGetValue("Largest Error", &value)) max_error_deg_->setValue(value.toDouble());
  if (config.mapGetValue("Largest Spread", &value)) max_spread_cm_->setValue(value.toDouble());
}

}  // namespace hexapod
