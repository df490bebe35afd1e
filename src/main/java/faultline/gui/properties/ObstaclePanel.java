package faultline.gui.properties;

import faultline.gui.canvas.tool.CanvasTools;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ObstacleEditor;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.TitledSection;
import faultline.gui.form.WrappingGridLayout;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.UiText;
import faultline.world.Obstacle;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.util.List;
import java.util.Set;
import javax.swing.AbstractListModel;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;

/**
 * The list of obstacles, which selects them by keys as well as on the canvas, the attributes of the selected one, and
 * buttons that arrange several.
 */
public final class ObstaclePanel extends JPanel {

    private static final int FRAMES_PER_UPDATE = 6;
    private static final int VISIBLE_ROWS = 7;
    private static final int LIST_WIDTH = 380;
    private static final int BUTTON_COLUMNS = 3;

    private final transient CommandSender sender;
    private final transient CanvasTools tools;
    private final ObstacleListModel ids = new ObstacleListModel();
    private final JList<String> list = new JList<>(ids);
    private final ObstacleForm form;
    private final JPanel buttons = new JPanel(new WrappingGridLayout());
    private boolean updating;
    private int skippedFrames = FRAMES_PER_UPDATE;

    /** Creates an empty panel, given what receives changes, what renames and what selects on the canvas. */
    public ObstaclePanel(CommandSender sender, ObstacleEditor editor, CanvasTools tools) {
        this.sender = sender;
        this.tools = tools;
        form = new ObstacleForm(sender, editor);
        setLayout(new BoxLayout(this, BoxLayout.PAGE_AXIS));
        list.setVisibleRowCount(VISIBLE_ROWS);
        list.setPrototypeCellValue("mmmmmmmmmmmm");
        UiText.name(list, "obstacles.list");
        list.addListSelectionListener(event -> {
            if (!updating && !event.getValueIsAdjusting()) {
                tools.select(list.getSelectedValuesList());
            }
        });
        tools.addSelectionListener(this::select);
        JScrollPane scroll = new JScrollPane(list);
        RefreshSteps.add(scroll, pane -> {
            pane.setPreferredSize(null);
            pane.setPreferredSize(new Dimension(TextSize.scaled(LIST_WIDTH), pane.getPreferredSize().height));
        });
        add(new TitledSection(scroll));
        add(new TitledSection("obstacles.selected", form));
        addButtons();
    }

    private void addButtons() {
        for (ObstacleArrangement arrangement : ObstacleArrangement.values()) {
            JButton button = UiText.button("arrange." + arrangement.name());
            UiText.tip(button, "arrange." + arrangement.name() + ".tip");
            button.addActionListener(event -> sender.send(arrangement.commands(tools.expectedSelection())));
            int index = arrangement.ordinal();
            buttons.add(button, FormConstraints.fillCell(index % BUTTON_COLUMNS, index / BUTTON_COLUMNS));
        }
        add(new TitledSection("arrange", buttons));
        enableButtons(0);
    }

    private void enableButtons(int selected) {
        ObstacleArrangement[] all = ObstacleArrangement.values();
        for (int i = 0; i < all.length; i++) {
            buttons.getComponent(i).setEnabled(selected >= all[i].minCount());
        }
    }

    /** Shows the obstacles of a frame, about ten times per second. */
    public void setObstacles(List<Obstacle> obstacles) {
        assert EventQueue.isDispatchThread();
        if (++skippedFrames < FRAMES_PER_UPDATE) {
            return;
        }
        skippedFrames = 0;
        updating = true;
        if (ids.update(obstacles)) {
            select(Set.copyOf(tools.selected().stream().map(Obstacle::id).toList()));
        }
        updating = false;
        List<Obstacle> selected = tools.selected();
        form.setObstacle(selected.size() == 1 ? selected.get(0) : null, obstacles);
        enableButtons(selected.size());
    }

    private void select(Set<String> selected) {
        skippedFrames = FRAMES_PER_UPDATE;
        // Selecting the same again would lose the row from which Shift extends the selection.
        if (!selected.equals(Set.copyOf(list.getSelectedValuesList()))) {
            selectRows(selected);
        }
    }

    private void selectRows(Set<String> selected) {
        boolean before = updating;
        updating = true;
        list.setValueIsAdjusting(true);
        list.clearSelection();
        if (!selected.isEmpty()) {
            for (int i = 0; i < ids.getSize(); i++) {
                if (selected.contains(ids.getElementAt(i))) {
                    list.addSelectionInterval(i, i);
                }
            }
            list.ensureIndexIsVisible(list.getMinSelectionIndex());
        }
        list.setValueIsAdjusting(false);
        updating = before;
    }

    /** The ids of the obstacles in drawing order. */
    private static final class ObstacleListModel extends AbstractListModel<String> {
        private List<String> ids = List.of();

        /** Takes the ids of obstacles and returns whether they have changed. */
        boolean update(List<Obstacle> obstacles) {
            boolean same = ids.size() == obstacles.size();
            for (int i = 0; same && i < ids.size(); i++) {
                same = ids.get(i).equals(obstacles.get(i).id());
            }
            if (!same) {
                ids = obstacles.stream().map(Obstacle::id).toList();
                fireContentsChanged(this, 0, Math.max(0, ids.size() - 1));
            }
            return !same;
        }

        @Override
        public int getSize() {
            return ids.size();
        }

        @Override
        public String getElementAt(int index) {
            return ids.get(index);
        }
    }
}
