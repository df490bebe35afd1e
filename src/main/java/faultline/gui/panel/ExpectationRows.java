package faultline.gui.panel;

import faultline.engine.metrics.Expectation;
import faultline.engine.metrics.RunFacts;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.MutedLabel;
import faultline.gui.form.ValueLabel;
import faultline.gui.form.WrappingGridLayout;
import faultline.gui.text.ExpectationText;
import faultline.gui.text.Messages;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.GlyphIcon;
import faultline.gui.theme.RefreshSteps;
import java.util.ArrayList;
import java.util.List;
import javax.swing.Icon;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** The expectations of the scenario, one per row: whether each holds so far, and the value. */
final class ExpectationRows extends JPanel {

    private static final int ICON_SIZE = 14;
    private static final Icon MET = new GlyphIcon(Glyph.CHECK, ICON_SIZE, colours -> colours.accent());
    private static final Icon OPEN = new GlyphIcon(Glyph.CIRCLE, ICON_SIZE, colours -> colours.muted());
    private static final Icon FAILED = new GlyphIcon(Glyph.REMOVE, ICON_SIZE, colours -> colours.warning());

    private final List<JLabel> labels = new ArrayList<>();
    private final List<ValueLabel> values = new ArrayList<>();
    /** Null before the first run. */
    private transient List<Expectation.Condition> items;

    ExpectationRows() {
        super(new WrappingGridLayout());
    }

    /** Shows how a run stands beside what is expected. Once it has ended, what does not hold has failed. */
    void setFacts(List<Expectation.Condition> required, RunFacts facts, boolean ended) {
        if (!required.equals(items)) {
            items = required;
            rebuild();
        }
        for (int i = 0; i < items.size(); i++) {
            setStatus(labels.get(i), items.get(i), items.get(i).unmet(facts).isEmpty(), ended);
            values.get(i).setValue(ExpectationText.value(items.get(i), facts));
        }
    }

    private static void setStatus(JLabel label, Expectation.Condition item, boolean met, boolean ended) {
        boolean failed = !met && (ended || item.equals(new Expectation.Collides(false)));
        Icon icon = met ? MET : failed ? FAILED : OPEN;
        if (label.getIcon() != icon) {
            label.setIcon(icon);
            String status = Messages.get(met ? "expect.met" : failed ? "expect.failed" : "expect.open");
            label.setToolTipText(status);
            label.getAccessibleContext().setAccessibleName(label.getText() + ": " + status);
        }
    }

    private void rebuild() {
        removeAll();
        labels.clear();
        values.clear();
        for (Expectation.Condition item : items) {
            JLabel label = RefreshSteps.add(new JLabel(), self -> {
                self.setText(ExpectationText.format(item));
                // The next status gives the other texts.
                self.setIcon(null);
            });
            ValueLabel value = new ValueLabel(
                    () -> ExpectationText.format(item),
                    () -> List.of(
                            "0000.0 mm",
                            Messages.get("expect.none"),
                            Messages.get("expect.collided"),
                            Messages.get("expect.notReached")));
            add(label, FormConstraints.fillCell(0, labels.size()));
            add(value, FormConstraints.cell(1, labels.size()));
            labels.add(label);
            values.add(value);
        }
        if (items.isEmpty()) {
            add(MutedLabel.ofKey("expect.nothing"), FormConstraints.fillCell(0, 0));
        }
        revalidate();
        repaint();
    }
}
