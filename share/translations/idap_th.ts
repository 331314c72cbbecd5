<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="th" sourcelanguage="en">
<context>
    <name>QFileDialog</name>
    <message>
        <source>Look in:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File &amp;name:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files of type:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parent Directory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create New Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detail View</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Date Modified</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select All</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QWidgetTextControl</name>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select All</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>cities</name>
    <message>
        <source>Amsterdam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Athens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auckland</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ayutthaya</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Baghdad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bangkok</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Barcelona</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beijing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Berlin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bogotá</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brussels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bucharest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Budapest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Buenos Aires</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cairo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cape Town</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Caracas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chiang Mai</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chiang Rai</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chicago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copenhagen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delhi</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Denver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dhaka</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dubai</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dublin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hanoi</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hat Yai</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Helsinki</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ho Chi Minh City</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hong Kong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Honolulu</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Istanbul</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jakarta</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Johannesburg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Karachi</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Khon Kaen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kuala Lumpur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kyiv</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lagos</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lima</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lisbon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>London</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Los Angeles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Madrid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Manila</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Melbourne</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mexico City</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Milan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Montreal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moscow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mumbai</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Munich</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nairobi</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nakhon Ratchasima</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New York</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Oslo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paris</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phnom Penh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phuket</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Prague</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reykjavik</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rio de Janeiro</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Riyadh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rome</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>San Francisco</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Santiago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>São Paulo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seoul</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shanghai</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Singapore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stockholm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sydney</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taipei</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tehran</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tel Aviv</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tokyo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Toronto</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Udon Thani</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vancouver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vienna</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vientiane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warsaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Washington</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yangon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zurich</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap</name>
    <message>
        <source>A furniture library cannot be read: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>modern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>classic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wood</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>glass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bedroom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>living</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dining</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kitchen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>office</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mirror</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>textile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>industrial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scandinavian</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hanging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>interior</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>entrance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>desk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drawers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pendant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sconce</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>steel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ceramic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>media</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>books</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>storage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>casement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fixed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sliding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>art</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coffee</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>small</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>armchair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>retro</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>succulent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flowers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>oven</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leather</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>velvet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bath</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>children</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>music</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture could not be made: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture was not saved: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture saved as %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finish</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change finish</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material, colour or picture of the whole piece.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As it comes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shininess</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change shininess</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From matt to a mirror, of the whole piece.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>usual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switched on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch lamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether it shines in pictures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change brightness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light of all its bulbs in lumens: an old 60 W bulb gives 800, a reading lamp 450, a ceiling lamp 2000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimmer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dim lamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of its light is on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change colour of light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour temperature: 1800 K candle, 2700 K warm white, 4000 K neutral, 6500 K daylight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change tint of light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A colour in place of the colour temperature, for coloured lamps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None: white light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change beam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full angle of a spot that shines down; 0: it shines all around.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Construction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cuts the floor above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change stair opening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes the hole in the floor above that one climbs through.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change construction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apple</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Armrests</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Baluster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Basket</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bedding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Body</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Books 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Books 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Books 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Books 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Border</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bowl</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bracket</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cactus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Candle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Carcass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Case</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Castors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ceramic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chrome</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curtain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark glass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Door</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duvet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fitting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flashing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fringe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Glass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grille</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Handle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hob</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marks on the hob</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Knob</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaf</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Legs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lemon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Louvre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mattress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Petal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pillow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plinth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Post</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Riser</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rod</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rug</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sash</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Soil</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stem</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stringer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Throw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Towel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tray</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tub</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wax</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wood</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness of the top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bars</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stems</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fronds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flowers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Doors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bar of the handle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seat height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the arms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spindles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Candles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror door number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shelves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panes across</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panes up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How full of books</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sashes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Basins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the bed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the foot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the mattress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the border</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far it hangs down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the mat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fruits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the flight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blades</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>General</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How it is called in lists and on the plan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name on the plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the name over the piece on the plan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Visible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change visibility</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hidden pieces are on no plan and in no picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change lock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A locked piece is not moved by the pointer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its middle, to the right of the origin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its middle, up the plan from the origin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its base above the floor; of a window the height of its sill.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From its left to its right. Sums are welcome: 120+15.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From its front to its back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From its base to its top.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep proportions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The other two sizes change along.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left and right exchanged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counter-clockwise on the plan, in degrees.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tilted forwards: lifts its back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tilted to its side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Price and origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Price</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change price</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of one piece, in the home&apos;s currency; empty: not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anything to remember about it: maker, order number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Creator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who made the model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Licence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under which terms the model may be passed on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lacquer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles and ceramic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plastic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plants</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is on the clipboard cannot be pasted: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selection cannot be copied: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove background picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show background picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Background picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compass and place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Title and notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be opened: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be saved: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No safety copy of this home can be kept: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 (%3 times)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>… and %1 more of the kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opened %1; some of it had to be mended or left out: see the messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved a compact copy as %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New room…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts an empty room: asks for its size along X, Y and Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another window, to work on two homes and copy between them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads a home of IDAP (.idap) or Sweet Home 3D (.sh3d)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the home to its file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the home to another file and goes on with that</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a &amp;compact copy…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes a copy without the models and pictures that nothing uses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the &amp;furniture list…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the list as a table (CSV) for a spreadsheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Prints the plan to scale, on paper or into a PDF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;references…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Units, language, light or dark, snapping and new walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close the home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the first page; asks about unsaved work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaves the program; asks about unsaved work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes back the last step; there is no limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Does again what was taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves the selection to the clipboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies the selection, also for other windows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts what was copied beside its original</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste in p&amp;lace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts what was copied where its original is, on this level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste into the &amp;group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was copied becomes part of the selected group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste st&amp;yle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gives the selection the finishes of what was copied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;roperties</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes to the numbers and finishes of the selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Property</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Eraser</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deletes what is selected; with nothing selected, what is clicked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find in the catalog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search for furniture by its name; Enter places it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Import furniture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds a model of your own, or a library of furniture, to the catalog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Title and notes…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The title on prints, and notes about the home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Compass and place…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where north is, the town, the date and the hour: they set the sun</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Background picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A scanned plan under the drawing, to draw it over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level &amp;properties…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name, elevation, height and floor of this level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearer; the wheel does it under the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Farther; the wheel does it under the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom to &amp;fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of the home, in every plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom to the &amp;selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is selected, as large as it fits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only plan &amp;X-Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plan from above, alone; again: all views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only elevation X-&amp;Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view from the front, alone; again: all views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only elevation &amp;Y-Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view from the right, alone; again: all views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the &amp;picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ray-traced picture, alone; again: all views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;All views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The three planes and the picture together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Maximise this view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view in use alone, or all again; so does a double click on its caption</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Ray trace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes the picture of the chosen point of view, while you go on working</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ray Trace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Catalog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The furniture, on the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Properties</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selection in numbers, on the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Lists</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Furniture, points of view and messages, below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every key and what it does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About IDAP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version, licence, and whose work is in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New from a &amp;template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Draw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;urniture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported the furniture list as %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The furniture list could not be written: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Align</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts the left edges of the selected pieces in line with the first one&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts the middles of the selected pieces above each other, as the first one stands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts the right edges of the selected pieces in line with the first one&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts the upper edges on the plan in line with the first one&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts the middles of the selected pieces beside each other, as the first one stands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts the lower edges on the plan in line with the first one&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts the pieces in line with the front of the first one, however it is turned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts the pieces in line with the back of the first one, however it is turned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts the pieces in line with the left side of the first one, however it is turned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts the pieces in line with the right side of the first one, however it is turned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts the pieces in a row without gaps, their backs in line with the first one&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizontally</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes the gaps from left to right equal; the outermost pieces stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertically</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes the gaps from bottom to top equal; the outermost pieces stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locked, and therefore still there: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes away what is selected. Undo brings it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts a copy of what is selected beside it, ready to be moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selects all that can be selected on this level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select all on all levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selects the whole home, to move or copy it as one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns what is selected by 90 degrees counter-clockwise about its middle; a door or window in its wall to the other side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns what is selected by 90 degrees clockwise about its middle; a door or window in its wall to the other side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exchanges left and right: of one piece where it stands, of several about their middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset elevation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put on the floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch lamps on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch lamps off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes one of the selected pieces, to be moved and turned together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the selected groups apart; their pieces stay where they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lets the selected pieces stand on what is under them: a table or the floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lowers or raises the selected pieces to the floor of their level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switches the selected lamps on, or all of the home when nothing is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switches the selected lamps off, or all of the home when nothing is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move level up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move level down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show only this level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add level above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds a storey on top of the current one; what is above moves up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add level at same elevation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds a level at the height of the current one, for a variant or another part of the house</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exchanges the current level with the one above it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exchanges the current level with the one below it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level visible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows or hides the current level in pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only this level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hides all other levels in pictures, to see into this one from above; once more shows them all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes away the current level with all that stands on it. Undo brings it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flip plan horizontally</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flip plan vertically</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock base plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walls, rooms, doors, windows, dimensions and labels cannot be selected then: furniture is arranged without moving them by mistake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flip horizontally</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exchanges left and right of the whole plan, on all levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flip vertically</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exchanges top and bottom of the whole plan, on all levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snapping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is drawn or moved jumps to ends, lines, walls, right angles and other pieces; hold Alt to suspend it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap to grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is drawn or moved keeps to the lines of the grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rooms by themselves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walls that close an area get a room with a floor and a ceiling at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the grid under the plans, to judge sizes by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rulers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows rulers at the top and left of the plans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the level below faintly under the current one, to draw walls above walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps what is selected where it is: it can be selected, but neither moved nor deleted until it is unlocked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes what is selected out of plans and pictures without deleting it; the furniture list still has it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows what is selected in the list but hidden in the plans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all hidden</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows all pieces and groups that were hidden, on every level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Join walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reverse walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straighten walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walls around room</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make rooms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walls close no area here that has no room yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Prolongs or shortens the two selected walls to where they meet, so that their corner is closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split in the middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes two walls of each selected one, to move or finish one part alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exchanges start and end, left and right of the selected walls; they look as before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes the selected round walls straight again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts walls along the outline of the selected rooms, outside of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make rooms of closed areas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gives every area that walls close on this level a room with a floor and a ceiling, where it has none yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That cannot be done: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the scale of the background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give a length on the scanned plan, and it gets its true size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click one end of a length that you know on the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>type the true length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag the scanned plan to where it belongs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a point of the picture to where it belongs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no snapping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click its other end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type the true length between them, then press Enter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The length must be more than nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>True length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put a point of view and aim it, for pictures and the live view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press where the eye is and drag to what it looks at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>type the height of the eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let go, or click, at what it looks at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Eye height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write a length on the plan, or a height beside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click where the measure starts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>type how far beside it is drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click where the measure ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click where the line is to be drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take away what you click; undo brings it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click what is to go, or drag over it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Erase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click takes this away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write on the plan: names, notes, anything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click where the text is to stand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>new line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drop it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type the text, then press Enter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Texts are written on the plan X-Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Doors and windows stand in walls: draw walls first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No wall has room left for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add door</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no free place left in this room: move the piece yourself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put a piece of the catalog into the home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click where the piece is to stand, or type its distances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn by 90°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>type a distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the next distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>place it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stands on top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add lamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add stairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add furniture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The catalog has no piece of this kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move it to a wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sill height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Doors and windows stand in walls: click on or beside one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the next way it opens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the other end, the sill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the wall where it is to be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put doors into walls; other kinds of doors are in the catalog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the wall where the door is to be, on the side it opens to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put windows into walls; other kinds are in the catalog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the wall where the window is to be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut passages into walls, with no door in them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the wall where the opening is to be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add opening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polyline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw lines on the plan: arrows, paths, outlines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click where the line starts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>type the length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>place the point, or end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>take the last point back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the next point; double-click to end, or click the first one to close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polylines are drawn on the plan X-Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add polyline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Room</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw the floor of a room, or fill the space between walls with one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click inside walls to fill them, or click the corners of the room</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>place the corner, or close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>take the last corner back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the next corner; on the first one, or double-click, to close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rooms are drawn on the plan X-Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No walls close around this point: draw the room corner by corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a room already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add room</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop it into a wall. The side of the pointer is where it opens to. Ctrl copies, Tab chooses a distance to type.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift keeps to one axis, Ctrl copies, Alt stops snapping.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a distance and press Enter; Tab chooses which. Shift keeps to one axis, Ctrl copies, Alt stops snapping.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to turn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to resize; Shift keeps the proportions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag up or down to lift or lower.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to tilt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the right: selects what lies wholly inside. To the left: also what it touches.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resize</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift keeps the proportions, Alt stops snapping. Or type the size and press Enter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resizes all together. Or type the width of all and press Enter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns in steps of 15°; Alt turns freely. Or type the angle and press Enter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tilts in steps of 15°; Alt tilts freely. Or type the angle and press Enter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag up or down to lift or lower. Or type the elevation and press Enter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw walls one after the other; where they close, they make a room</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click where the first wall starts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle, thickness, arc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>place it, or end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>round wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>take the last one back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click where the wall ends, or type its length; double-click or right-click to stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click where the round wall passes, or type its arc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walls are drawn on the plan X-Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a wall already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arc</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::AboutDialog</name>
    <message>
        <source>About IDAP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw or open a home, furnish it, and see it as it would really look. It carries on a DOS program of 1993, the Interior Design Assisting Program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later: you may use, study, share and change it. It comes without any warranty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Furniture and weights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Furniture libraries name the creator and the licence of each piece in the catalog&apos;s tooltips. Denoising uses the weights of Intel Open Image Denoise (Apache-2.0), where they are installed.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::BackgroundDialog</name>
    <message>
        <source>It is not a PNG or JPEG picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is larger than %1 pixels. Make it smaller with a paint program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is damaged: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No picture yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a picture of the plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” cannot be used. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Background picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A scanned plan (PNG or JPEG) lies under the drawing of this level. Choose it, then click two points on it whose distance you know: it gets its true size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1.  &amp;Choose a picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2.  &amp;Set its size by two points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3.  &amp;Move it into place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Visible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click two points on the plan, then type the length between them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag it where the drawing is, or the drawing will be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes it from this level; undo brings it back</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::BackgroundJob</name>
    <message>
        <source>There is not enough memory for it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::CatalogPanel</name>
    <message>
        <source>Search furniture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Names, tags, categories and creators, in English or Thai. Enter places the first piece found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show only pieces that fit into a space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>W</source>
        <comment>width</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D</source>
        <comment>depth</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>H</source>
        <comment>height</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most this wide; empty: any width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most this deep; empty: any depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most this high; empty: any height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Any size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kinds of furniture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Categories</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Furniture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing found. Try fewer words, another category or any size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bring in a furniture library or a model file of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading furniture libraries</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n piece(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Reading libraries…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place in the room</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts it where it fits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place with the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It follows the pointer and stays where you click, as often as you like</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Price: %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Licence: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Library: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::CategoryList</name>
    <message>
        <source>All furniture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>★ Favourites</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recently used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From libraries</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1, %n pieces</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>idap::ChipRow</name>
    <message>
        <source>Show only pieces tagged “%1”</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::ColorButton</name>
    <message>
        <source>Used last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colour as #rrggbb, from a paint chart for example. Enter takes it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More colours…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No colour of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Several values</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::CompassFace</name>
    <message>
        <source>N</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::FileFlow</name>
    <message>
        <source>Homes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” could not be opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” could not be saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your work is still open here and nothing of it is lost. Save it in another place, or free some space and try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” was changed by another program since you opened it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving here would replace those changes with yours.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Room</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” cannot be written in its own format, so the home is saved as an IDAP home beside it. The original stays as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the home as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>IDAP homes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a compact copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>compact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without saving, what you did since the last time is lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a new home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program did not end in order last time. A copy of %1 from %2 is there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restored, it opens as unsaved work; the file itself is not touched.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Throw away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask &amp;later</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::FinishSection</name>
    <message>
        <source>Reading the parts of the model…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model cannot be read: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As it comes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material, colour or picture of this part.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::HintLine</name>
    <message>
        <source>Furnish the room: drag furniture from the catalog on the left into a plane, or choose it there and press Enter.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::HomeFile</name>
    <message>
        <source>Reading %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::JobIndicator</name>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::KeysDialog</name>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What they do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::LengthField</name>
    <message>
        <source>“%1” is not a length. Write a number, with a unit if you like, or a sum: 120, 3.25 m, 10&apos;8&quot;, 120+15.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::LevelBar</name>
    <message>
        <source>Ground floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw on this level; a double click changes its name and heights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a level above this one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add level</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::LevelDialog</name>
    <message>
        <source>Level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Height of the rooms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the floor to the ceiling; new walls are this high</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Elevation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Floor thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the top of its floor above the ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the slab under this level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Visible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seen in pictures and, faintly, under the level above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;In use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counts when the home is built; a level kept for later does not</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::MainWindow</name>
    <message>
        <source>Wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Room</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Furniture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points of view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Messages (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Catalog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Properties</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lists</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the pointer is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scale of the plan on this screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the furniture list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::MaterialPicker</name>
    <message>
        <source>As it comes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Several finishes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, tinted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture for this face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is too large: pictures may have up to 64 MB.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a picture this program can read.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::MaterialPopup</name>
    <message>
        <source>Search materials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes material, colour and picture away again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The material&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A colour of its own; with a material, it is tinted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lays a picture over the face, a photograph of tiles for example.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What one copy of the picture covers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From matt to a mirror.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shininess</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::NewRoomDialog</name>
    <message>
        <source>New room</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::NewRoomForm</name>
    <message>
        <source>Width &amp;X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth &amp;Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height &amp;Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The clear size between the walls. Takes units and sums: 4.2m, 13&apos;6&quot;, 320+45.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes a room of this size with four walls, ready to be furnished</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::NumberField</name>
    <message>
        <source>“%1” is not a number. Write a number or a sum: 45, 2.5, 30+15.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This must be a whole number.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::ParametersSection</name>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::PicturePanel</name>
    <message>
        <source>Where the picture is seen from: above, or a camera of the home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ray Trace: make a picture of the home as it is now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop tracing and keep the picture as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the picture as a PNG or JPEG file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give this view the whole window, and back (double click)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No picture yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ray Trace shows your home in its real light, from above or from a camera.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ray Trace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture of an earlier state: Ray Trace again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The home has changed since this picture was begun</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the picture is: it becomes finer until then</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1 is a date such as &quot;21 Dec&quot;, %2 a time of day</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The time of the picture&apos;s daylight: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preparing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JPEG picture (*.jpg *.jpeg)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::PlanCaption</name>
    <message>
        <source>Plan X-Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front X-Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side Y-Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seen from above. Double click to fill the window with it, or to go back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seen from the front. Double click to fill the window with it, or to go back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seen from the right. Double click to fill the window with it, or to go back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill the window with this view, or go back</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::PreferencesDialog</name>
    <message>
        <source>Solid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hatched upwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hatched downwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cross-hatched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Unit of length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feet and inches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lengths are shown in it; any unit can be typed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Snap to ends, lines, walls and pieces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Alt key turns it off while it is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap to the gr&amp;id</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the &amp;grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the &amp;rulers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the level &amp;below faintly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Walls that &amp;close make a room</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Th&amp;ickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>that of the home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Empty: the height of the level, or of the home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pattern</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::Recovery</name>
    <message>
        <source>Keeping a copy</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::SiteDialog</name>
    <message>
        <source>Compass and place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Town</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Latitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>L&amp;ongitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time &amp;zone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Date and hour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;North</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the &amp;compass on the plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets place and time zone; type to find it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>North of the equator positive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>East of Greenwich positive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The home&apos;s own time: where the sun stands in its pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clockwise from up the page; the rose can be turned by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(another place)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::TextArea</name>
    <message>
        <source>Several values</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::TextDialog</name>
    <message>
        <source>Title and notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Na&amp;me of the home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Printed above the plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anything worth remembering about this home; kept in its file</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::TextField</name>
    <message>
        <source>Several values</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::ValueField</name>
    <message>
        <source>Several values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This must be at least %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This must be at most %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>idap::WelcomePage</name>
    <message>
        <source>Starts a new home like this one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a home, furnish it, and see it as it would really look. Nothing can go wrong: everything can be undone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New room</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start from a template</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recent homes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Homes you open or save appear here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open a home…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads a home of IDAP (.idap) or Sweet Home 3D (.sh3d)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
