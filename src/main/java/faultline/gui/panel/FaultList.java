package faultline.gui.panel;

import faultline.gui.edit.Editor;
import faultline.gui.text.Texts;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.GlyphIcon;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.SensorSnapshot;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.util.List;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** The active faults, oldest first for each sensor, each with a button that mends it. */
final class FaultList extends JPanel {

    private static final GlyphIcon SIGN = new GlyphIcon(Glyph.WARNING, 16, colours -> Optional.of(colours.warning()));
    private static final GlyphIcon CROSS = new GlyphIcon(Glyph.REMOVE, 14, colours -> Optional.of(colours.text()));

    private final transient Editor editor;
    private transient List<Active> shown = List.of();

    /** One fault of one sensor. */
    private record Active(String sensor, Fault fault) {
    }

    FaultList(Editor editor) {
        super(new GridBagLayout());
        this.editor = editor;
        rebuild();
    }

    void show(List<SensorSnapshot> sensors) {
        List<Active> now = sensors.stream()
                .flatMap(sensor -> sensor.faults().stream().map(fault -> new Active(sensor.spec().id(), fault))).toList();
        if (!now.equals(shown)) {
            shown = now;
            rebuild();
        }
    }

    private void rebuild() {
        removeAll();
        if (shown.isEmpty()) {
            add(new MutedLabel(Texts.text("faults.none")), Grid.wide(0, 0));
        } else {
            for (int row = 0; row < shown.size(); row++) {
                addRow(row, shown.get(row));
            }
            if (shown.size() > 1) {
                addClearAll(shown.size());
            }
        }
        revalidate();
        repaint();
    }

    private void addRow(int row, Active active) {
        String text = active.sensor() + ": " + ReadingText.of(active.fault());
        add(new JLabel(text, SIGN, JLabel.LEADING), Grid.wide(0, row));
        JButton mend = new JButton(CROSS);
        mend.setBorder(BorderFactory.createEmptyBorder(3, 5, 3, 5));
        mend.setToolTipText(Texts.text("faults.mend", text));
        mend.getAccessibleContext().setAccessibleName(Texts.text("faults.mend", text));
        mend.addActionListener(event -> editor.send(new Command.ClearFault(active.sensor(), active.fault())));
        add(mend, Grid.cell(1, row));
    }

    private void addClearAll(int row) {
        JButton all = new JButton(Texts.text("faults.mendAll"));
        all.addActionListener(event -> editor.send(shown.stream().map(Active::sensor).distinct().<Command>map(Command.ClearFaults::new).toList()));
        GridBagConstraints place = Grid.rest(0, row);
        place.fill = GridBagConstraints.NONE;
        place.anchor = GridBagConstraints.LINE_END;
        place.insets.top += 4;
        add(all, place);
    }
}
