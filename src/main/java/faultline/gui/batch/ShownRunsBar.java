package faultline.gui.batch;

import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.UiText;
import java.awt.BorderLayout;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** Says below a view of runs that it shows those of the selected row of the summary only, and shows all of them. */
final class ShownRunsBar extends JPanel {

    private final JLabel text = new JLabel();
    private final JButton showAll = UiText.button("batch.showAll");
    private String row = "";
    private int shown;
    private int all;

    /** Creates a hidden bar; {@code onShowAll} is called when the user wants to see all runs. */
    private ShownRunsBar(Runnable onShowAll) {
        super(new BorderLayout(8, 0));
        setBorder(BorderFactory.createEmptyBorder(4, 8, 4, 8));
        UiText.tip(showAll, "batch.showAll.tip");
        showAll.addActionListener(event -> onShowAll.run());
        add(text, BorderLayout.CENTER);
        add(showAll, BorderLayout.LINE_END);
        setVisible(false);
        RefreshSteps.add(text, self -> updateText());
    }

    /** Returns a bar that has been added below a view, in a panel with both. */
    static ShownRunsBar below(JComponent view, Runnable onShowAll) {
        ShownRunsBar bar = new ShownRunsBar(onShowAll);
        JPanel panel = new JPanel(new BorderLayout());
        // After the view in the order of the focus, so that a tab that opens gives it to the view.
        panel.add(bar, BorderLayout.SOUTH);
        panel.add(view, BorderLayout.CENTER);
        return bar;
    }

    /** Shows the labels of the selected row, and how many of all runs it has. */
    void showRow(String labels, int runs, int total) {
        row = labels;
        shown = runs;
        all = total;
        updateText();
        setVisible(true);
    }

    private void updateText() {
        text.setText(Messages.get("batch.shown", row, Integer.toString(shown), Integer.toString(all)));
    }
}
