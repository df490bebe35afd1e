package faultline.gui.instrument;

import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import java.awt.Component;
import java.awt.event.ActionEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.function.IntUnaryOperator;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JSplitPane;
import javax.swing.KeyStroke;

/**
 * A split pane whose divider can be placed before the pane has a size, and which keeps that position when the pane is
 * resized. If the user moves the divider, the new position replaces it.
 */
public final class PositionedSplitPane extends JSplitPane {

    private static final String RETURN_FOCUS = "returnFocus";

    /** Maps the available size to the position of the divider; null before the first call of {@link #place}. */
    private transient IntUnaryOperator place;

    private int placedSize;
    private boolean placing;
    private boolean moved;
    /** The component that had the focus before the divider, null before the first time. */
    private transient Component lastFocused;

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
        addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent event) {
                remember(event.getOppositeComponent());
            }
        });
        // The Tab key stops at components that have bindings for their own focus.
        getInputMap(WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("ESCAPE"), RETURN_FOCUS);
        getActionMap().put(RETURN_FOCUS, new AbstractAction() {
            @Override
            public boolean isEnabled() {
                return isFocusOwner() && lastFocused != null;
            }

            @Override
            public void actionPerformed(ActionEvent event) {
                lastFocused.requestFocusInWindow(FocusEvent.Cause.TRAVERSAL);
            }
        });
        addPropertyChangeListener(DIVIDER_LOCATION_PROPERTY, event -> {
            if (!placing) {
                rememberPosition(getDividerLocation(), availableSize());
            }
        });
    }

    /** Keeps the component that had the focus before; one divider may get it from another. */
    private void remember(Component before) {
        if (before instanceof PositionedSplitPane other) {
            lastFocused = other.lastFocused;
        } else if (before != null) {
            lastFocused = before;
        }
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
