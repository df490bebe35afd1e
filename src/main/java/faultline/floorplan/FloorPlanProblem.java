package faultline.floorplan;

import faultline.io.Message;
import faultline.io.MessageText;

/**
 * The kinds of problem of maps and their images, and the rules for values in map files, with the English text of each.
 */
public enum FloorPlanProblem implements Message.Template {
    /** A value in a map file is not allowed. */
    VALUE("{0} is \"{1}\"; expected {2}"),
    /** A line of a map file is not an entry. */
    LINE("a line is \"{0}\"; expected \"key: value\""),
    /** A map file has a key twice. */
    DUPLICATE_KEY("\"{0}\" is given twice; expected once"),
    /** A map file lacks a key. */
    MISSING_KEY("there is no \"{0}\"; a map file needs it"),
    /** A map file has a misspelt key. */
    MISSPELT_KEY("there is no \"{0}\"; \"{1}\" may be a misspelling of it"),
    /** A map file has an unknown key that is similar to a known one; a note, because other programs have keys, too. */
    UNKNOWN_KEY("\"{0}\" is not a key of maps and is ignored; did you mean \"{1}\"?"),
    /** The map file is not text. */
    NOT_UTF_8("the file is not UTF-8 text"),
    /** The map file has a character that no YAML file has. */
    CONTROL_CHARACTER("the character U+{0} is not allowed in YAML; the file may be damaged"),
    /** The kind of file that is expected. */
    MAP_FILE("map file"),
    /** The rule for any number. */
    NUMBER("a number"),
    /** The rule for a key with a single value. */
    ONE_VALUE("one value"),
    /** The rule for the side of a cell. */
    RESOLUTION("a number of metres from 0.000001 to 100000"),
    /** The rule for thresholds. */
    SHARE("a number from 0 to 1"),
    /** The rule for {@code negate}. */
    NEGATE("0 or 1"),
    /** The rule for {@code origin}. */
    ORIGIN("three numbers, [x, y, yaw] in metres and radians"),
    /** The rule for the yaw in {@code origin}. */
    YAW("[x, y, yaw] with a yaw of at most {0} radians"),
    /** The rule for {@code image}. */
    IMAGE_NAME("the name of an image file"),
    /** The rule for {@code image} if the named file does not exist. */
    EXISTING_IMAGE("the name of an image file, but there is no file {0}"),
    /** The rule for {@code image} if the named file is a folder or a device. */
    REGULAR_IMAGE("the name of an image file, but {0} is not a regular file"),
    /** The image does not exist. */
    NO_SUCH_IMAGE("there is no such image file"),
    /** The path of the image is not a regular file. */
    IRREGULAR_IMAGE("this is not a regular file; expected an image file"),
    /** The image cannot be read. */
    UNREADABLE_IMAGE("the image cannot be read: {0}"),
    /** The reason why a truncated image cannot be read. */
    ENDS_TOO_EARLY("the file ends too early"),
    /** The reason why a damaged image cannot be read. */
    DAMAGED("the file is damaged"),
    /** A chunk of a PNG file does not match its checksum. */
    CHECKSUM("the checksum of the chunk {0} at byte {1} is wrong; the image is damaged"),
    /** The file is no image. */
    IMAGE_FORMAT("the format of the image is not supported; expected PGM (P2, P5), PNG, BMP, GIF or TIFF"),
    /** The image has too many pixels or none. */
    IMAGE_SIZE("the image has {0} x {1} pixels; expected 1 to {2}"),
    /** The pixels of a TIFF image have a number of bits that is not supported. */
    PIXEL_BITS("a pixel of the image has {0} bits; expected 1, 2, 4, 8 or 16"),
    /** The samples of a TIFF image with several samples per pixel have a number of bits that is not supported. */
    SAMPLE_BITS("the number of bits of a sample of the image is {0}; expected 8 or 16"),
    /** The samples of a TIFF image are signed. */
    SIGNED_SAMPLES("the samples of the image are signed integers; expected unsigned ones"),
    /** The pixels of a TIFF image with a palette have further samples. */
    PALETTE_SAMPLES("the image has a palette and {0} samples per pixel; expected 1"),
    /** The samples of a TIFF image are neither grey nor RGB nor indices of a palette. */
    PHOTOMETRIC("the photometric interpretation of the image is {0}; expected 0 to 3, which is grey, RGB or a palette"),
    /** The pixels are compressed in a way that is refused. */
    COMPRESSION("the compression of the image is not supported: {0}"),
    /** The image is a portable map of another kind. */
    PORTABLE_FORMAT("the format of the image is P{0}; expected P2 or P5"),
    /** The maximum value of a portable grey map is not allowed. */
    MAX_SAMPLE("the maximum value is {0}; expected 1 to {1}"),
    /** A raw grey map has too few pixels. */
    TOO_FEW_BYTES("the image ends after {0} bytes of pixels, {1} are needed"),
    /** A pixel of a grey map exceeds the maximum value. */
    PIXEL_VALUE("pixel {0} is {1}; expected 0 to {2}"),
    /** A portable grey map lacks a number. */
    MISSING_NUMBER("{0} is missing at byte {1}"),
    /** A portable grey map has something else in the place of a number. */
    WRONG_NUMBER("{0} is \"{1}\" at byte {2}; expected a whole number"),
    /** The missing number is the width. */
    WIDTH("the width"),
    /** The missing number is the height. */
    HEIGHT("the height"),
    /** The missing number is the maximum value. */
    MAX_VALUE("the maximum value"),
    /** The missing number is a pixel. */
    PIXEL("pixel {0}"),
    /** The map is larger than a world. */
    MAP_SIZE("the map measures {0} x {1} m; expected at most {2} m;"
            + " the resolution, which is the side of a pixel, may be wrong"),
    /** The map has too many wall segments. */
    SEGMENTS("the map has {0} wall segments; expected at most {1};"
            + " drop specks, straighten outlines or use a coarser image"),
    /** The map does not fit into the memory. */
    MEMORY("the map needs more memory than the program has; start Java with more, such as -Xmx2g"),
    /**
     * The place that is farthest from everything solid is too small for the robot. The last argument lists the settings
     * that may help, as they are called where the sentence is shown.
     */
    NO_ROOM("the robot, {0} m long and {1} m wide, has no room in the free space of this map of {2} x {3} m;"
            + " what may help: {4}");

    private final String english;

    FloorPlanProblem(String english) {
        this.english = english;
    }

    @Override
    public String key() {
        return "floorPlan." + MessageText.camelCase(name());
    }

    @Override
    public String english() {
        return english;
    }
}
