package faultline.floorplan;

import java.util.OptionalInt;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataFormatImpl;
import javax.imageio.metadata.IIOMetadataNode;

/** The metadata of an image in the JDK's standard format: properties that its readers do not apply to all pixels. */
final class StandardMetadata {

    private final IIOMetadataNode root;

    /** Creates the metadata of an image. */
    StandardMetadata(IIOMetadata metadata) {
        root = (IIOMetadataNode) metadata.getAsTree(IIOMetadataFormatImpl.standardMetadataFormatName);
    }

    /**
     * Returns the sample of the transparent level of a grey image; empty if it has none. A level of 1, 2 or 4 bits is
     * scaled as its pixels are. Further bits in the file do not count.
     *
     * @param white the sample of white
     */
    OptionalInt transparentSample(int white) {
        String level = value("TransparentColor");
        if (level.isEmpty()) {
            return OptionalInt.empty();
        }
        int max = (1 << Integer.parseInt(value("BitsPerSample"))) - 1;
        return OptionalInt.of((Integer.parseInt(level) & max) * (white / max));
    }

    /** Returns whether the file stores white as 0. */
    boolean isWhiteZero() {
        return value("BlackIsZero").equals("FALSE");
    }

    /** Returns the value of an element as a number; 0 if there is no such element. */
    int number(String element) {
        String value = value(element);
        return value.isEmpty() ? 0 : Integer.parseInt(value);
    }

    /** Returns the value of an element; empty if there is no such element. */
    String value(String element) {
        return root.getElementsByTagName(element).item(0) instanceof IIOMetadataNode node
                ? node.getAttribute("value")
                : "";
    }
}
