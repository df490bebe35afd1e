package faultline.gui.panel;

import faultline.gui.edit.UndoController;
import faultline.gui.text.Messages;
import faultline.gui.text.ReadingText;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.GlyphIcon;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.UiText;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.SensorSnapshot;
import java.awt.GridBagConstraints;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** The active faults, oldest first for each sensor, each with a button that repairs it. */
final class FaultList extends JPanel {

    private static final GlyphIcon WARNING_ICON = new GlyphIcon(Glyph.WARNING, 16, colours -> colours.warning());
    private static final GlyphIcon REMOVE_ICON = new GlyphIcon(Glyph.REMOVE, 14, colours -> colours.text());

    private final transient UndoController editor;
    private transient List<ListedFault> shownFaults = List.of();

    /** A fault of a sensor. */
    private record ListedFault(String sensor, Fault fault) {}

    FaultList(UndoController editor) {
        super(new WrappingGridLayout());
        this.editor = editor;
        rebuild();
    }

    void setSensors(List<SensorSnapshot> sensors) {
        List<ListedFault> now = sensors.stream()
                .flatMap(sensor -> sensor.faults().stream()
                        .map(fault -> new ListedFault(sensor.spec().id(), fault)))
                .toList();
        if (!now.equals(shownFaults)) {
            shownFaults = now;
            rebuild();
        }
    }

    private void rebuild() {
        removeAll();
        if (shownFaults.isEmpty()) {
            add(MutedLabel.ofKey("faults.none"), FormConstraints.fillCell(0, 0));
        } else {
            for (int row = 0; row < shownFaults.size(); row++) {
                addRow(row, shownFaults.get(row));
            }
            if (shownFaults.size() > 1) {
                addClearAll(shownFaults.size());
            }
        }
        revalidate();
        repaint();
    }

    private void addRow(int row, ListedFault active) {
        // Two labels, so that a narrow panel can show the fault below its sensor.
        add(new JLabel(active.sensor() + ":", WARNING_ICON, JLabel.LEADING), FormConstraints.cell(0, row));
        JLabel fault = RefreshSteps.add(new JLabel(), self -> self.setText(ReadingText.format(active.fault())));
        add(fault, FormConstraints.fillCell(1, row));
        JButton mend = new JButton(REMOVE_ICON);
        mend.setBorder(BorderFactory.createEmptyBorder(3, 5, 3, 5));
        RefreshSteps.add(mend, button -> {
            button.setToolTipText(Messages.get("faults.repair", text(active)));
            button.getAccessibleContext().setAccessibleName(button.getToolTipText());
        });
        mend.addActionListener(event -> editor.send(new Command.ClearFault(active.sensor(), active.fault())));
        add(mend, FormConstraints.cell(2, row));
    }

    private static String text(ListedFault active) {
        return active.sensor() + ": " + ReadingText.format(active.fault());
    }

    private void addClearAll(int row) {
        JButton all = UiText.button("faults.repairAll");
        all.addActionListener(event -> editor.send(shownFaults.stream()
                .map(ListedFault::sensor)
                .distinct()
                .<Command>map(Command.ClearFaults::new)
                .toList()));
        GridBagConstraints constraints = FormConstraints.fillRow(0, row);
        constraints.fill = GridBagConstraints.NONE;
        constraints.anchor = GridBagConstraints.LINE_END;
        constraints.insets.top += 4;
        add(all, constraints);
    }
}
