package faultline.gui.instrument;

import java.awt.Component;
import java.util.Optional;
import java.util.function.IntUnaryOperator;
import javax.swing.BorderFactory;
import javax.swing.JSplitPane;

/**
 * A split pane whose divider can be placed before the pane has a size, and keeps to its place whenever the pane gets
 * another one. Where somebody moves it, that is its place.
 */
public final class PositionedSplitPane extends JSplitPane {

    private transient Optional<IntUnaryOperator> place = Optional.empty();
    private int placedSize;
    private boolean placing;

    /**
     * A split pane without a border that lays out while its divider is dragged.
     *
     * @param orientation of {@link JSplitPane}
     * @param before left or above
     * @param after right or below
     * @param weight how much of the room that a larger pane has goes before a divider that somebody has moved, in [0,
     *     1]
     */
    public PositionedSplitPane(int orientation, Component before, Component after, double weight) {
        super(orientation, before, after);
        setResizeWeight(weight);
        setContinuousLayout(true);
        setBorder(BorderFactory.createEmptyBorder());
        addPropertyChangeListener(DIVIDER_LOCATION_PROPERTY, moved -> {
            if (!placing) {
                rememberPosition(getDividerLocation(), availableSize());
            }
        });
    }

    /**
     * Places the divider.
     *
     * @param location its place for a size of the pane less the divider's, pixels
     */
    public void place(IntUnaryOperator location) {
        place = Optional.of(location);
        placedSize = 0;
        runPlacing(this::placeIfSized);
        revalidate();
    }

    /** Somebody has moved the divider: from there it goes on by its share of what the pane grows or shrinks. */
    private void rememberPosition(int location, int room) {
        double share = getResizeWeight();
        place = Optional.of(size -> location + (int) Math.round(share * (size - room)));
        placedSize = room;
    }

    /** Laid out first, because a pane that has not been yet moves a divider once more. */
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
        boolean due = place.isPresent() && size > 0 && size != placedSize;
        if (due) {
            setDividerLocation(Math.max(0, Math.min(place.get().applyAsInt(size), size)));
            placedSize = size;
        }
        return due;
    }

    private int availableSize() {
        return (getOrientation() == VERTICAL_SPLIT ? getHeight() : getWidth()) - getDividerSize();
    }
}
