package faultline.campaign.run;

import faultline.io.Message;
import faultline.io.MessageText;

/** The problems of the results of a campaign, with the English text of each. */
public enum ResultsProblem implements Message.Template {
    /** There is no table. */
    NO_CAMPAIGN("there is no campaign"),
    /** The folder cannot be read. */
    UNREADABLE("the folder cannot be read"),
    /** The table is a device or a pipe. */
    NOT_REGULAR("this is not a regular file; expected a table"),
    /** The table is not text. */
    NOT_TEXT("the file cannot be read as UTF-8 text"),
    /** A line is so long that the file is no table. */
    LONG_ROW("the row is too long; expected at most 1 MiB"),
    /** The table has no row. */
    NO_ROW("there is no row of a run; expected at least one below the header"),
    /** A column is missing. */
    NO_COLUMN("the header has no column {0}; expected names with commas between them"),
    /** A column is there twice. */
    COLUMN_TWICE("the header has the column {0} twice; expected it once"),
    /** A row has another number of cells than the header. */
    CELL_COUNT("the row has {0} cells; expected {1} like the header"),
    /** A row has one cell. */
    ONE_CELL("the row has 1 cell; expected {0} like the header"),
    /** A cell has a value that its column cannot have. */
    CELL("{0} is {1}; expected {2}"),
    /** A run is not in the plan. */
    NOT_IN_PLAN("run {0} is not in the plan; expected 0 to {1}"),
    /** A run is in the table twice. */
    TWICE("run {0} is there twice; expected each run once"),
    /** A row has a byte that text does not have. */
    ZERO_BYTE("the row has a byte of zero"),
    /** There are more rows than runs. */
    TOO_MANY_ROWS("there is a row after that of the last run; expected {0} rows"),
    /** A row of a campaign in progress is wrong. */
    WRONG_ROW("{0}; restore the table, or delete this row and those below to make their runs again"),

    /** A count. */
    WHOLE_NUMBER("a whole number"),
    /** A word of a list. */
    ONE_OF("one of {0}"),
    /** A flag. */
    FLAG("0, 1 or nothing"),
    /** A number that need not be there. */
    NUMBER("a number or nothing"),
    /** A time. */
    DURATION("a number from 0 to {0}"),
    /** A share that need not be there. */
    SHARE("a number from 0 to 1 or nothing"),
    /** A number that is not negative and need not be there. */
    SIZE("a number of at least 0 or nothing"),
    /** A count that need not be there. */
    COUNT("a whole number of at least 0 or nothing"),
    /** A hash. */
    HASH("16 of the digits 0 to 9 and a to f"),
    /** A word of a list that need not be there. */
    ONE_OF_OR_NOTHING("one of {0} or nothing"),
    /** Any text but an empty one. */
    VALUE("a value"),
    /** An empty text. */
    NOTHING("nothing"),
    /** A lower limit. */
    AT_LEAST("at least {0}"),
    /** An upper limit, which is a value of another column. */
    AT_MOST_OF("at most {0}, the value of {1}"),
    /** What is expected because another column has a value or has none. */
    AS_IN("{0} as in {1}"),
    /** What is expected because of an outcome. */
    WITH_OUTCOME("{0} with the outcome {1}");

    private final String english;

    ResultsProblem(String english) {
        this.english = english;
    }

    @Override
    public String key() {
        return "resultsProblem." + MessageText.camelCase(name());
    }

    @Override
    public String english() {
        return english;
    }
}
