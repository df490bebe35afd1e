package faultline.gui.panel;

import faultline.control.SensorFinding;
import faultline.control.SensorHealth;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.MutedLabel;
import faultline.gui.form.ValueLabel;
import faultline.gui.form.WrappingGridLayout;
import faultline.gui.text.Messages;
import faultline.gui.text.NumberText;
import faultline.gui.theme.TextSize;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** The findings of the controller's diagnosis about each sensor. */
final class HealthRows extends JPanel {

    private static final double PERCENT = 100;
    private static final String LONGEST_SINCE = "0000.00 s";
    private static final double MAX_EXACT_SECONDS = 9999.995;
    /** The width that an id has if there is room, and that below which it is not shortened, at the normal text size. */
    private static final int NAME_WIDTH = 92;

    private static final int MIN_NAME_WIDTH = 48;

    private record HealthRow(JLabel name, ValueLabel finding, ValueLabel evidence, ValueLabel since) {

        void clear() {
            Stream.of(finding, evidence, since).forEach(value -> value.setValue(ValueLabel.NONE));
        }
    }

    /** The id of a sensor, shortened if its column is too narrow for it. Its tool tip is the whole id. */
    private static final class NameLabel extends JLabel {

        NameLabel(String id) {
            super(id);
            setToolTipText(id);
        }

        @Override
        public Dimension getPreferredSize() {
            return limitedTo(NAME_WIDTH);
        }

        @Override
        public Dimension getMinimumSize() {
            return limitedTo(MIN_NAME_WIDTH);
        }

        private Dimension limitedTo(int width) {
            Dimension natural = super.getPreferredSize();
            return new Dimension(Math.min(natural.width, TextSize.scaled(width)), natural.height);
        }
    }

    private final transient List<HealthRow> rows = new ArrayList<>();
    /** Null before the first run. */
    private List<String> sensors;

    HealthRows() {
        super(new WrappingGridLayout());
    }

    /**
     * Shows the health of the sensors, which is empty before the first finding; there are rows for the diagnosed ones
     * even then.
     */
    void setHealth(List<String> diagnosed, List<SensorHealth> health, double dt) {
        List<String> now = health.isEmpty()
                ? diagnosed
                : health.stream().map(SensorHealth::sensor).toList();
        if (!now.equals(sensors)) {
            sensors = now;
            rebuild();
        }
        if (health.isEmpty()) {
            rows.forEach(HealthRow::clear);
        }
        for (int i = 0; i < health.size(); i++) {
            SensorHealth sensor = health.get(i);
            HealthRow row = rows.get(i);
            row.finding.setValue(name(sensor.finding()));
            row.evidence.setValue(
                    sensor.evidence() > 0
                            ? NumberText.format("%.0f %%", PERCENT * sensor.evidence())
                            : ValueLabel.NONE);
            // The time at the end of the tick, as in the event log.
            row.since.setValue(sensor.isTrusted() ? ValueLabel.NONE : sinceText((sensor.sinceTick() + 1) * dt));
        }
    }

    /** Returns a time, in whole seconds if it would be longer than {@link #LONGEST_SINCE} with hundredths. */
    private static String sinceText(double seconds) {
        return NumberText.format(seconds < MAX_EXACT_SECONDS ? "%.2f s" : "%.0f s", seconds);
    }

    private static String name(SensorFinding finding) {
        return Messages.get("health.finding." + finding.name());
    }

    private void rebuild() {
        removeAll();
        rows.clear();
        if (sensors.isEmpty()) {
            add(MutedLabel.ofKey("health.none"), FormConstraints.fillCell(0, 0));
        } else {
            String[] headings = {"sensors.sensor", "health.finding", "health.evidence", "health.since"};
            for (int i = 0; i < headings.length; i++) {
                add(MutedLabel.ofKey(headings[i]), FormConstraints.cell(i + 1, 0));
            }
            sensors.forEach(this::addRow);
        }
        revalidate();
        repaint();
    }

    private static ValueLabel value(String sensor, String key, Supplier<List<String>> widest) {
        return new ValueLabel(() -> sensor + ": " + Messages.get(key), widest);
    }

    private void addRow(String id) {
        HealthRow row = new HealthRow(
                new NameLabel(id),
                value(id, "health.finding", () -> Stream.of(SensorFinding.values())
                        .map(HealthRows::name)
                        .toList()),
                value(id, "health.evidence", () -> List.of("100 %")),
                value(id, "health.since", () -> List.of(LONGEST_SINCE)));
        int y = rows.size() + 1;
        add(new SensorBadge(rows.size()), FormConstraints.centredCell(0, y));
        add(row.name, FormConstraints.fillCell(1, y));
        add(row.finding, FormConstraints.cell(2, y));
        add(row.evidence, FormConstraints.cell(3, y));
        add(row.since, FormConstraints.cell(4, y));
        rows.add(row);
    }
}
