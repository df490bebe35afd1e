package faultline.gui.instrument;

import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import java.awt.Component;
import java.util.function.IntUnaryOperator;
import javax.swing.BorderFactory;
import javax.swing.JSplitPane;
import javax.swing.KeyStroke;

/**
 * A split pane whose divider can be placed before the pane has a size, and which keeps that position when the pane is
 * resized. If the user moves the divider, the new position replaces it.
 */
public final class PositionedSplitPane extends JSplitPane {

    /** Maps the available size to the position of the divider; null before the first call of {@link #place}. */
    private transient IntUnaryOperator place;

    private int placedSize;
    private boolean placing;
    private boolean moved;

    /**
     * Creates a split pane without a border and with continuous layout, given the key of the name of the divider for
     * screen readers, an orientation of {@link JSplitPane}, and the share of additional space, in [0, 1], that goes to
     * the first component after the user has moved the divider.
     */
    public PositionedSplitPane(String nameKey, int orientation, Component before, Component after, double weight) {
        super(orientation, before, after);
        RefreshSteps.add(this, self -> self.getAccessibleContext().setAccessibleName(Messages.get(nameKey)));
        setResizeWeight(weight);
        setContinuousLayout(true);
        setBorder(BorderFactory.createEmptyBorder());
        // Swing would move the focus between both sides of the pane; the window moves it between all areas.
        getInputMap(WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("F6"), "none");
        addPropertyChangeListener(DIVIDER_LOCATION_PROPERTY, event -> {
            if (!placing) {
                rememberPosition(getDividerLocation(), availableSize());
            }
        });
    }

    /** Places the divider at a function of the size of the pane, less that of the divider, pixels. */
    public void place(IntUnaryOperator location) {
        place = location;
        placedSize = 0;
        moved = false;
        runPlacing(this::placeIfSized);
        revalidate();
    }

    /** Stores the position chosen by the user, which then moves with its share of the pane's growth. */
    private void rememberPosition(int location, int room) {
        double share = getResizeWeight();
        place = size -> location + (int) Math.round(share * (size - room));
        placedSize = room;
        moved = true;
    }

    /** Returns whether the user has moved the divider since it was placed. */
    public boolean isMoved() {
        return moved;
    }

    /** Lays out first, because a pane that has not been laid out moves the divider once more. */
    @Override
    public void doLayout() {
        runPlacing(() -> {
            super.doLayout();
            if (placeIfSized()) {
                super.doLayout();
            }
        });
    }

    private void runPlacing(Runnable moves) {
        placing = true;
        try {
            moves.run();
        } finally {
            placing = false;
        }
    }

    private boolean placeIfSized() {
        int size = availableSize();
        boolean due = place != null && size > 0 && size != placedSize;
        if (due) {
            setDividerLocation(Math.max(0, Math.min(place.applyAsInt(size), size)));
            placedSize = size;
        }
        return due;
    }

    private int availableSize() {
        return (getOrientation() == VERTICAL_SPLIT ? getHeight() : getWidth()) - getDividerSize();
    }
}
