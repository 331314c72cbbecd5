<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="th" sourcelanguage="en">
<context>
    <name>FurnitureList</name>
    <message>
        <source>Name</source>
        <translation>ชื่อ</translation>
    </message>
    <message>
        <source>What it is called; double click to rename</source>
        <translation>ชื่อของชิ้นนี้ ดับเบิลคลิกเพื่อเปลี่ยนชื่อ</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>กว้าง</translation>
    </message>
    <message>
        <source>From its left to its right</source>
        <translation>จากด้านซ้ายถึงด้านขวา</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>ลึก</translation>
    </message>
    <message>
        <source>From its front to its back</source>
        <translation>จากด้านหน้าถึงด้านหลัง</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>สูง</translation>
    </message>
    <message>
        <source>From its base to its top</source>
        <translation>จากฐานถึงยอด</translation>
    </message>
    <message>
        <source>Place of its middle to the right of the origin</source>
        <translation>ตำแหน่งจุดกึ่งกลาง วัดไปทางขวาจากจุดกำเนิด</translation>
    </message>
    <message>
        <source>Place of its middle up the page from the origin</source>
        <translation>ตำแหน่งจุดกึ่งกลาง วัดขึ้นไปจากจุดกำเนิด</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>ระดับจากพื้น</translation>
    </message>
    <message>
        <source>Of its base above the floor</source>
        <translation>ความสูงของฐานเหนือพื้น</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>มุม</translation>
    </message>
    <message>
        <source>Turned counter-clockwise on the plan</source>
        <translation>หมุนทวนเข็มนาฬิกาบนแปลน</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>เอนหน้า-หลัง</translation>
    </message>
    <message>
        <source>Leaning back</source>
        <translation>เอนไปด้านหลัง</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>เอียงข้าง</translation>
    </message>
    <message>
        <source>Leaning sideways</source>
        <translation>เอียงไปด้านข้าง</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>ชั้น</translation>
    </message>
    <message>
        <source>The storey that it stands on</source>
        <translation>ชั้นของบ้านที่ชิ้นนี้ตั้งอยู่</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>ชนิด</translation>
    </message>
    <message>
        <source>Furniture, lamp, door, window, stairs or group</source>
        <translation>เฟอร์นิเจอร์ โคมไฟ ประตู หน้าต่าง บันได หรือกลุ่ม</translation>
    </message>
    <message>
        <source>Category</source>
        <translation>หมวดหมู่</translation>
    </message>
    <message>
        <source>Where it is found in the catalog</source>
        <translation>หมวดที่อยู่ในแค็ตตาล็อก</translation>
    </message>
    <message>
        <source>Price</source>
        <translation>ราคา</translation>
    </message>
    <message>
        <source>In the home&apos;s currency; double click to change</source>
        <translation>เป็นสกุลเงินของบ้านนี้ ดับเบิลคลิกเพื่อแก้ไข</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>แสดง</translation>
    </message>
    <message>
        <source>Shown on plans and in pictures</source>
        <translation>แสดงบนแปลนและในภาพ</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>ล็อก</translation>
    </message>
    <message>
        <source>Cannot be moved by the pointer</source>
        <translation>ย้ายด้วยเมาส์ไม่ได้</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>กลับด้าน</translation>
    </message>
    <message>
        <source>Left and right exchanged</source>
        <translation>สลับซ้ายขวา</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>แสงไฟ</translation>
    </message>
    <message>
        <source>Luminous flux of a lamp, in lumens</source>
        <translation>ฟลักซ์ส่องสว่างของโคมไฟ หน่วยลูเมน</translation>
    </message>
    <message>
        <source>Creator</source>
        <translation>ผู้สร้าง</translation>
    </message>
    <message>
        <source>Who made the model</source>
        <translation>ผู้สร้างโมเดล</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>สัญญาอนุญาต</translation>
    </message>
    <message>
        <source>How the model may be used</source>
        <translation>เงื่อนไขการใช้โมเดล</translation>
    </message>
    <message>
        <source>Catalog ID</source>
        <translation>รหัสแค็ตตาล็อก</translation>
    </message>
    <message>
        <source>By which the catalog knows it</source>
        <translation>รหัสที่แค็ตตาล็อกใช้เรียก</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>คำอธิบาย</translation>
    </message>
    <message>
        <source>What the file says about it</source>
        <translation>คำอธิบายที่มากับไฟล์</translation>
    </message>
    <message>
        <source>%1 lm</source>
        <translation>%1 ลูเมน</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Look in:</source>
        <translation>มองหาใน:</translation>
    </message>
    <message>
        <source>File &amp;name:</source>
        <translation>ชื่อไฟล์(&amp;N):</translation>
    </message>
    <message>
        <source>Files of type:</source>
        <translation>ชนิดไฟล์:</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>เปิด(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>บันทึก(&amp;S)</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>คอมพิวเตอร์</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>ย้อนกลับ</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>ไปข้างหน้า</translation>
    </message>
    <message>
        <source>Parent Directory</source>
        <translation>โฟลเดอร์แม่</translation>
    </message>
    <message>
        <source>Create New Folder</source>
        <translation>สร้างโฟลเดอร์ใหม่</translation>
    </message>
    <message>
        <source>List View</source>
        <translation>มุมมองรายการ</translation>
    </message>
    <message>
        <source>Detail View</source>
        <translation>มุมมองรายละเอียด</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Name</source>
        <translation>ชื่อ</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>ขนาด</translation>
    </message>
    <message>
        <source>Date Modified</source>
        <translation>วันที่แก้ไข</translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation>เลิกทำ(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>ทำซ้ำ(&amp;R)</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>ตัด(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>คัดลอก(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>วาง(&amp;P)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>ลบ</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>เลือกทั้งหมด</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>ตกลง</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>บันทึก</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>เปิด</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>ใช่(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>ไม่(&amp;N)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>ปิด</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>ยกเลิก</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>ไม่บันทึก</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>นำไปใช้</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>ตั้งใหม่</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>คืนค่าเริ่มต้น</translation>
    </message>
</context>
<context>
    <name>QWidgetTextControl</name>
    <message>
        <source>&amp;Undo</source>
        <translation>เลิกทำ(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>ทำซ้ำ(&amp;R)</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>ตัด(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>คัดลอก(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>วาง(&amp;P)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>ลบ</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>เลือกทั้งหมด</translation>
    </message>
</context>
<context>
    <name>cities</name>
    <message>
        <source>Amsterdam</source>
        <translation>อัมสเตอร์ดัม</translation>
    </message>
    <message>
        <source>Athens</source>
        <translation>เอเธนส์</translation>
    </message>
    <message>
        <source>Auckland</source>
        <translation>โอ๊กแลนด์</translation>
    </message>
    <message>
        <source>Ayutthaya</source>
        <translation>อยุธยา</translation>
    </message>
    <message>
        <source>Baghdad</source>
        <translation>แบกแดด</translation>
    </message>
    <message>
        <source>Bangkok</source>
        <translation>กรุงเทพฯ</translation>
    </message>
    <message>
        <source>Barcelona</source>
        <translation>บาร์เซโลนา</translation>
    </message>
    <message>
        <source>Beijing</source>
        <translation>ปักกิ่ง</translation>
    </message>
    <message>
        <source>Berlin</source>
        <translation>เบอร์ลิน</translation>
    </message>
    <message>
        <source>Bogotá</source>
        <translation>โบโกตา</translation>
    </message>
    <message>
        <source>Brussels</source>
        <translation>บรัสเซลส์</translation>
    </message>
    <message>
        <source>Bucharest</source>
        <translation>บูคาเรสต์</translation>
    </message>
    <message>
        <source>Budapest</source>
        <translation>บูดาเปสต์</translation>
    </message>
    <message>
        <source>Buenos Aires</source>
        <translation>บัวโนสไอเรส</translation>
    </message>
    <message>
        <source>Cairo</source>
        <translation>ไคโร</translation>
    </message>
    <message>
        <source>Cape Town</source>
        <translation>เคปทาวน์</translation>
    </message>
    <message>
        <source>Caracas</source>
        <translation>การากัส</translation>
    </message>
    <message>
        <source>Chiang Mai</source>
        <translation>เชียงใหม่</translation>
    </message>
    <message>
        <source>Chiang Rai</source>
        <translation>เชียงราย</translation>
    </message>
    <message>
        <source>Chicago</source>
        <translation>ชิคาโก</translation>
    </message>
    <message>
        <source>Copenhagen</source>
        <translation>โคเปนเฮเกน</translation>
    </message>
    <message>
        <source>Delhi</source>
        <translation>เดลี</translation>
    </message>
    <message>
        <source>Denver</source>
        <translation>เดนเวอร์</translation>
    </message>
    <message>
        <source>Dhaka</source>
        <translation>ธากา</translation>
    </message>
    <message>
        <source>Dubai</source>
        <translation>ดูไบ</translation>
    </message>
    <message>
        <source>Dublin</source>
        <translation>ดับลิน</translation>
    </message>
    <message>
        <source>Hanoi</source>
        <translation>ฮานอย</translation>
    </message>
    <message>
        <source>Hat Yai</source>
        <translation>หาดใหญ่</translation>
    </message>
    <message>
        <source>Helsinki</source>
        <translation>เฮลซิงกิ</translation>
    </message>
    <message>
        <source>Ho Chi Minh City</source>
        <translation>โฮจิมินห์ซิตี</translation>
    </message>
    <message>
        <source>Hong Kong</source>
        <translation>ฮ่องกง</translation>
    </message>
    <message>
        <source>Honolulu</source>
        <translation>โฮโนลูลู</translation>
    </message>
    <message>
        <source>Istanbul</source>
        <translation>อิสตันบูล</translation>
    </message>
    <message>
        <source>Jakarta</source>
        <translation>จาการ์ตา</translation>
    </message>
    <message>
        <source>Johannesburg</source>
        <translation>โจฮันเนสเบิร์ก</translation>
    </message>
    <message>
        <source>Karachi</source>
        <translation>การาจี</translation>
    </message>
    <message>
        <source>Khon Kaen</source>
        <translation>ขอนแก่น</translation>
    </message>
    <message>
        <source>Kuala Lumpur</source>
        <translation>กัวลาลัมเปอร์</translation>
    </message>
    <message>
        <source>Kyiv</source>
        <translation>เคียฟ</translation>
    </message>
    <message>
        <source>Lagos</source>
        <translation>ลากอส</translation>
    </message>
    <message>
        <source>Lima</source>
        <translation>ลิมา</translation>
    </message>
    <message>
        <source>Lisbon</source>
        <translation>ลิสบอน</translation>
    </message>
    <message>
        <source>London</source>
        <translation>ลอนดอน</translation>
    </message>
    <message>
        <source>Los Angeles</source>
        <translation>ลอสแอนเจลิส</translation>
    </message>
    <message>
        <source>Madrid</source>
        <translation>มาดริด</translation>
    </message>
    <message>
        <source>Manila</source>
        <translation>มะนิลา</translation>
    </message>
    <message>
        <source>Melbourne</source>
        <translation>เมลเบิร์น</translation>
    </message>
    <message>
        <source>Mexico City</source>
        <translation>เม็กซิโกซิตี</translation>
    </message>
    <message>
        <source>Milan</source>
        <translation>มิลาน</translation>
    </message>
    <message>
        <source>Montreal</source>
        <translation>มอนทรีออล</translation>
    </message>
    <message>
        <source>Moscow</source>
        <translation>มอสโก</translation>
    </message>
    <message>
        <source>Mumbai</source>
        <translation>มุมไบ</translation>
    </message>
    <message>
        <source>Munich</source>
        <translation>มิวนิก</translation>
    </message>
    <message>
        <source>Nairobi</source>
        <translation>ไนโรบี</translation>
    </message>
    <message>
        <source>Nakhon Ratchasima</source>
        <translation>นครราชสีมา</translation>
    </message>
    <message>
        <source>New York</source>
        <translation>นิวยอร์ก</translation>
    </message>
    <message>
        <source>Oslo</source>
        <translation>ออสโล</translation>
    </message>
    <message>
        <source>Paris</source>
        <translation>ปารีส</translation>
    </message>
    <message>
        <source>Perth</source>
        <translation>เพิร์ท</translation>
    </message>
    <message>
        <source>Phnom Penh</source>
        <translation>พนมเปญ</translation>
    </message>
    <message>
        <source>Phuket</source>
        <translation>ภูเก็ต</translation>
    </message>
    <message>
        <source>Prague</source>
        <translation>ปราก</translation>
    </message>
    <message>
        <source>Reykjavik</source>
        <translation>เรคยาวิก</translation>
    </message>
    <message>
        <source>Rio de Janeiro</source>
        <translation>รีโอเดจาเนโร</translation>
    </message>
    <message>
        <source>Riyadh</source>
        <translation>ริยาด</translation>
    </message>
    <message>
        <source>Rome</source>
        <translation>โรม</translation>
    </message>
    <message>
        <source>San Francisco</source>
        <translation>ซานฟรานซิสโก</translation>
    </message>
    <message>
        <source>Santiago</source>
        <translation>ซันติอาโก</translation>
    </message>
    <message>
        <source>São Paulo</source>
        <translation>เซาเปาลู</translation>
    </message>
    <message>
        <source>Seoul</source>
        <translation>โซล</translation>
    </message>
    <message>
        <source>Shanghai</source>
        <translation>เซี่ยงไฮ้</translation>
    </message>
    <message>
        <source>Singapore</source>
        <translation>สิงคโปร์</translation>
    </message>
    <message>
        <source>Stockholm</source>
        <translation>สตอกโฮล์ม</translation>
    </message>
    <message>
        <source>Sydney</source>
        <translation>ซิดนีย์</translation>
    </message>
    <message>
        <source>Taipei</source>
        <translation>ไทเป</translation>
    </message>
    <message>
        <source>Tehran</source>
        <translation>เตหะราน</translation>
    </message>
    <message>
        <source>Tel Aviv</source>
        <translation>เทลอาวีฟ</translation>
    </message>
    <message>
        <source>Tokyo</source>
        <translation>โตเกียว</translation>
    </message>
    <message>
        <source>Toronto</source>
        <translation>โทรอนโต</translation>
    </message>
    <message>
        <source>Udon Thani</source>
        <translation>อุดรธานี</translation>
    </message>
    <message>
        <source>Vancouver</source>
        <translation>แวนคูเวอร์</translation>
    </message>
    <message>
        <source>Vienna</source>
        <translation>เวียนนา</translation>
    </message>
    <message>
        <source>Vientiane</source>
        <translation>เวียงจันทน์</translation>
    </message>
    <message>
        <source>Warsaw</source>
        <translation>วอร์ซอ</translation>
    </message>
    <message>
        <source>Washington</source>
        <translation>วอชิงตัน</translation>
    </message>
    <message>
        <source>Yangon</source>
        <translation>ย่างกุ้ง</translation>
    </message>
    <message>
        <source>Zurich</source>
        <translation>ซูริก</translation>
    </message>
</context>
<context>
    <name>idap</name>
    <message>
        <source>A furniture library cannot be read: %1</source>
        <translation>อ่านคลังเฟอร์นิเจอร์ไม่ได้: %1</translation>
    </message>
    <message>
        <source>modern</source>
        <translation>โมเดิร์น</translation>
    </message>
    <message>
        <source>classic</source>
        <translation>คลาสสิก</translation>
    </message>
    <message>
        <source>wood</source>
        <translation>ไม้</translation>
    </message>
    <message>
        <source>glass</source>
        <translation>แก้ว</translation>
    </message>
    <message>
        <source>bedroom</source>
        <translation>ห้องนอน</translation>
    </message>
    <message>
        <source>living</source>
        <translation>นั่งเล่น</translation>
    </message>
    <message>
        <source>dining</source>
        <translation>ทานอาหาร</translation>
    </message>
    <message>
        <source>kitchen</source>
        <translation>ครัว</translation>
    </message>
    <message>
        <source>office</source>
        <translation>สำนักงาน</translation>
    </message>
    <message>
        <source>hall</source>
        <translation>โถง</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>ติดผนัง</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>กระจก</translation>
    </message>
    <message>
        <source>lamp</source>
        <translation>โคมไฟ</translation>
    </message>
    <message>
        <source>pot</source>
        <translation>กระถาง</translation>
    </message>
    <message>
        <source>base</source>
        <translation>ตู้ล่าง</translation>
    </message>
    <message>
        <source>textile</source>
        <translation>ผ้า</translation>
    </message>
    <message>
        <source>industrial</source>
        <translation>อินดัสเทรียล</translation>
    </message>
    <message>
        <source>scandinavian</source>
        <translation>สแกนดิเนเวียน</translation>
    </message>
    <message>
        <source>hanging</source>
        <translation>แขวน</translation>
    </message>
    <message>
        <source>interior</source>
        <translation>ภายใน</translation>
    </message>
    <message>
        <source>entrance</source>
        <translation>ทางเข้า</translation>
    </message>
    <message>
        <source>desk</source>
        <translation>โต๊ะทำงาน</translation>
    </message>
    <message>
        <source>drawers</source>
        <translation>ลิ้นชัก</translation>
    </message>
    <message>
        <source>pendant</source>
        <translation>โคมแขวน</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>เพดาน</translation>
    </message>
    <message>
        <source>standing</source>
        <translation>ตั้งพื้น</translation>
    </message>
    <message>
        <source>sconce</source>
        <translation>ไฟผนัง</translation>
    </message>
    <message>
        <source>round</source>
        <translation>กลม</translation>
    </message>
    <message>
        <source>steel</source>
        <translation>เหล็ก</translation>
    </message>
    <message>
        <source>ceramic</source>
        <translation>เซรามิก</translation>
    </message>
    <message>
        <source>media</source>
        <translation>สื่อ</translation>
    </message>
    <message>
        <source>books</source>
        <translation>หนังสือ</translation>
    </message>
    <message>
        <source>storage</source>
        <translation>เก็บของ</translation>
    </message>
    <message>
        <source>casement</source>
        <translation>บานเปิด</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>บานติดตาย</translation>
    </message>
    <message>
        <source>sliding</source>
        <translation>บานเลื่อน</translation>
    </message>
    <message>
        <source>art</source>
        <translation>งานศิลปะ</translation>
    </message>
    <message>
        <source>coffee</source>
        <translation>กาแฟ</translation>
    </message>
    <message>
        <source>tall</source>
        <translation>สูง</translation>
    </message>
    <message>
        <source>small</source>
        <translation>เล็ก</translation>
    </message>
    <message>
        <source>bar</source>
        <translation>บาร์</translation>
    </message>
    <message>
        <source>armchair</source>
        <translation>เก้าอี้นวม</translation>
    </message>
    <message>
        <source>stool</source>
        <translation>สตูล</translation>
    </message>
    <message>
        <source>retro</source>
        <translation>ย้อนยุค</translation>
    </message>
    <message>
        <source>succulent</source>
        <translation>ไม้อวบน้ำ</translation>
    </message>
    <message>
        <source>flowers</source>
        <translation>ดอกไม้</translation>
    </message>
    <message>
        <source>sink</source>
        <translation>อ่างล้าง</translation>
    </message>
    <message>
        <source>oven</source>
        <translation>เตาอบ</translation>
    </message>
    <message>
        <source>leather</source>
        <translation>หนัง</translation>
    </message>
    <message>
        <source>fabric</source>
        <translation>ผ้า</translation>
    </message>
    <message>
        <source>velvet</source>
        <translation>กำมะหยี่</translation>
    </message>
    <message>
        <source>spot</source>
        <translation>สปอตไลต์</translation>
    </message>
    <message>
        <source>bath</source>
        <translation>อ่างอาบน้ำ</translation>
    </message>
    <message>
        <source>shower</source>
        <translation>ฝักบัว</translation>
    </message>
    <message>
        <source>children</source>
        <translation>เด็ก</translation>
    </message>
    <message>
        <source>music</source>
        <translation>ดนตรี</translation>
    </message>
    <message>
        <source>computer</source>
        <translation>คอมพิวเตอร์</translation>
    </message>
    <message>
        <source>The picture could not be made: %1</source>
        <translation>สร้างภาพไม่ได้: %1</translation>
    </message>
    <message>
        <source>The picture was not saved: %1</source>
        <translation>ไม่ได้บันทึกภาพ: %1</translation>
    </message>
    <message>
        <source>Picture saved as %1</source>
        <translation>บันทึกภาพเป็น %1 แล้ว</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>ผิววัสดุ</translation>
    </message>
    <message>
        <source>All of it</source>
        <translation>ทั้งชิ้น</translation>
    </message>
    <message>
        <source>Change finish</source>
        <translation>เปลี่ยนผิววัสดุ</translation>
    </message>
    <message>
        <source>Material, colour or picture of the whole piece.</source>
        <translation>วัสดุ สี หรือรูปภาพของทั้งชิ้น</translation>
    </message>
    <message>
        <source>As it comes</source>
        <translation>ตามเดิม</translation>
    </message>
    <message>
        <source>Shininess</source>
        <translation>ความเงา</translation>
    </message>
    <message>
        <source>Change shininess</source>
        <translation>เปลี่ยนความเงา</translation>
    </message>
    <message>
        <source>From matt to a mirror, of the whole piece.</source>
        <translation>ตั้งแต่ด้านจนเงาเหมือนกระจก ทั้งชิ้น</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>ปกติ</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>แสงไฟ</translation>
    </message>
    <message>
        <source>Switched on</source>
        <translation>เปิดไฟ</translation>
    </message>
    <message>
        <source>Switch lamp</source>
        <translation>เปิดปิดโคมไฟ</translation>
    </message>
    <message>
        <source>Whether it shines in pictures.</source>
        <translation>ให้ส่องสว่างในภาพหรือไม่</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>ความสว่าง</translation>
    </message>
    <message>
        <source>Change brightness</source>
        <translation>เปลี่ยนความสว่าง</translation>
    </message>
    <message>
        <source>Light of all its bulbs in lumens: an old 60 W bulb gives 800, a reading lamp 450, a ceiling lamp 2000.</source>
        <translation>แสงรวมของทุกหลอด หน่วยลูเมน: หลอดไส้ 60 วัตต์ 800 โคมอ่านหนังสือ 450 โคมเพดาน 2000</translation>
    </message>
    <message>
        <source>Dimmer</source>
        <translation>หรี่ไฟ</translation>
    </message>
    <message>
        <source>Dim lamp</source>
        <translation>หรี่โคมไฟ</translation>
    </message>
    <message>
        <source>How much of its light is on.</source>
        <translation>ให้แสงออกเท่าใดจากทั้งหมด</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>สี</translation>
    </message>
    <message>
        <source>Change colour of light</source>
        <translation>เปลี่ยนสีของแสง</translation>
    </message>
    <message>
        <source>Colour temperature: 1800 K candle, 2700 K warm white, 4000 K neutral, 6500 K daylight.</source>
        <translation>อุณหภูมิสี: 1800 K แสงเทียน 2700 K วอร์มไวต์ 4000 K คูลไวต์ 6500 K เดย์ไลต์</translation>
    </message>
    <message>
        <source>Tint</source>
        <translation>ย้อมสี</translation>
    </message>
    <message>
        <source>Change tint of light</source>
        <translation>เปลี่ยนสีย้อมของแสง</translation>
    </message>
    <message>
        <source>A colour in place of the colour temperature, for coloured lamps.</source>
        <translation>ใช้สีแทนอุณหภูมิสี สำหรับโคมไฟสี</translation>
    </message>
    <message>
        <source>None: white light</source>
        <translation>ไม่มี: แสงขาว</translation>
    </message>
    <message>
        <source>Beam</source>
        <translation>ลำแสง</translation>
    </message>
    <message>
        <source>Change beam</source>
        <translation>เปลี่ยนลำแสง</translation>
    </message>
    <message>
        <source>Full angle of a spot that shines down; 0: it shines all around.</source>
        <translation>มุมเต็มของลำแสงที่ส่องลง 0 คือส่องรอบทิศ</translation>
    </message>
    <message>
        <source>Cuts the floor above</source>
        <translation>เจาะพื้นชั้นบน</translation>
    </message>
    <message>
        <source>Change stair opening</source>
        <translation>เปลี่ยนช่องบันได</translation>
    </message>
    <message>
        <source>Makes the hole in the floor above that one climbs through.</source>
        <translation>เจาะช่องในพื้นชั้นบนให้เดินขึ้นไปได้</translation>
    </message>
    <message>
        <source>Accent</source>
        <translation>ส่วนเน้น</translation>
    </message>
    <message>
        <source>Apple</source>
        <translation>แอปเปิล</translation>
    </message>
    <message>
        <source>Armrests</source>
        <translation>ที่วางแขน</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>ด้านหลัง</translation>
    </message>
    <message>
        <source>Baluster</source>
        <translation>ลูกกรง</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>ฐาน</translation>
    </message>
    <message>
        <source>Basket</source>
        <translation>ตะกร้า</translation>
    </message>
    <message>
        <source>Bedding</source>
        <translation>เครื่องนอน</translation>
    </message>
    <message>
        <source>Blade</source>
        <translation>ใบพัด</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>ตัวเรือน</translation>
    </message>
    <message>
        <source>Books 1</source>
        <translation>หนังสือ 1</translation>
    </message>
    <message>
        <source>Books 2</source>
        <translation>หนังสือ 2</translation>
    </message>
    <message>
        <source>Books 3</source>
        <translation>หนังสือ 3</translation>
    </message>
    <message>
        <source>Books 4</source>
        <translation>หนังสือ 4</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>ขอบ</translation>
    </message>
    <message>
        <source>Bowl</source>
        <translation>ชาม</translation>
    </message>
    <message>
        <source>Bracket</source>
        <translation>ขายึด</translation>
    </message>
    <message>
        <source>Cactus</source>
        <translation>กระบองเพชร</translation>
    </message>
    <message>
        <source>Candle</source>
        <translation>เทียน</translation>
    </message>
    <message>
        <source>Cane</source>
        <translation>หวายสาน</translation>
    </message>
    <message>
        <source>Carcass</source>
        <translation>โครงตู้</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>ตัวกล่อง</translation>
    </message>
    <message>
        <source>Castors</source>
        <translation>ล้อ</translation>
    </message>
    <message>
        <source>Ceramic</source>
        <translation>เซรามิก</translation>
    </message>
    <message>
        <source>Chrome</source>
        <translation>โครเมียม</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>กรวย</translation>
    </message>
    <message>
        <source>Curtain</source>
        <translation>ม่าน</translation>
    </message>
    <message>
        <source>Dark glass</source>
        <translation>กระจกดำ</translation>
    </message>
    <message>
        <source>Dial</source>
        <translation>หน้าปัด</translation>
    </message>
    <message>
        <source>Door</source>
        <translation>ประตู</translation>
    </message>
    <message>
        <source>Drain</source>
        <translation>สะดือน้ำทิ้ง</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>ระย้า</translation>
    </message>
    <message>
        <source>Duvet</source>
        <translation>ผ้านวม</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>ผ้า</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>หน้าปัด</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>แผ่นกรอง</translation>
    </message>
    <message>
        <source>Fitting</source>
        <translation>ขั้วโคม</translation>
    </message>
    <message>
        <source>Flame</source>
        <translation>เปลวไฟ</translation>
    </message>
    <message>
        <source>Flashing</source>
        <translation>แผ่นปิดรอยต่อ</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>กรอบ</translation>
    </message>
    <message>
        <source>Fringe</source>
        <translation>ชายครุย</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>ด้านหน้า</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>กระจก</translation>
    </message>
    <message>
        <source>Grass</source>
        <translation>หญ้า</translation>
    </message>
    <message>
        <source>Grate</source>
        <translation>ตะแกรงเตา</translation>
    </message>
    <message>
        <source>Grille</source>
        <translation>ตะแกรง</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>มือจับ</translation>
    </message>
    <message>
        <source>Hands</source>
        <translation>เข็มนาฬิกา</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>ใจกลาง</translation>
    </message>
    <message>
        <source>Hob</source>
        <translation>หัวเตา</translation>
    </message>
    <message>
        <source>Marks on the hob</source>
        <translation>เครื่องหมายบนเตา</translation>
    </message>
    <message>
        <source>Holder</source>
        <translation>ที่ยึด</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>ด้านใน</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>ข้อต่อ</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>ปุ่มลัด</translation>
    </message>
    <message>
        <source>Knob</source>
        <translation>ปุ่มจับ</translation>
    </message>
    <message>
        <source>Leaf</source>
        <translation>บาน</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>ขา</translation>
    </message>
    <message>
        <source>Lemon</source>
        <translation>เลมอน</translation>
    </message>
    <message>
        <source>Louvre</source>
        <translation>บานเกล็ด</translation>
    </message>
    <message>
        <source>Mat</source>
        <translation>กระดาษรองภาพ</translation>
    </message>
    <message>
        <source>Mattress</source>
        <translation>ที่นอน</translation>
    </message>
    <message>
        <source>Metal</source>
        <translation>โลหะ</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>กลับด้าน</translation>
    </message>
    <message>
        <source>Nails</source>
        <translation>หมุด</translation>
    </message>
    <message>
        <source>Pad</source>
        <translation>เบาะ</translation>
    </message>
    <message>
        <source>Pads</source>
        <translation>เบาะ</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>แผง</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>กระดาษ</translation>
    </message>
    <message>
        <source>Pear</source>
        <translation>ลูกแพร์</translation>
    </message>
    <message>
        <source>Petal</source>
        <translation>กลีบดอก</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>ภาพ</translation>
    </message>
    <message>
        <source>Pillow</source>
        <translation>หมอน</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>แผ่นรอง</translation>
    </message>
    <message>
        <source>Plinth</source>
        <translation>ฐานล่าง</translation>
    </message>
    <message>
        <source>Post</source>
        <translation>เสา</translation>
    </message>
    <message>
        <source>Pot</source>
        <translation>กระถาง</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>ราว</translation>
    </message>
    <message>
        <source>Riser</source>
        <translation>ลูกตั้ง</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>รางม่าน</translation>
    </message>
    <message>
        <source>Rug</source>
        <translation>พรม</translation>
    </message>
    <message>
        <source>Sash</source>
        <translation>กรอบบาน</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>จอ</translation>
    </message>
    <message>
        <source>Seal</source>
        <translation>ขอบยาง</translation>
    </message>
    <message>
        <source>Seat</source>
        <translation>ที่นั่ง</translation>
    </message>
    <message>
        <source>Shade</source>
        <translation>โป๊ะโคม</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>ชั้นวาง</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>เปลือก</translation>
    </message>
    <message>
        <source>Sill</source>
        <translation>ขอบล่าง</translation>
    </message>
    <message>
        <source>Sink</source>
        <translation>อ่างล้าง</translation>
    </message>
    <message>
        <source>Soil</source>
        <translation>ดิน</translation>
    </message>
    <message>
        <source>Spines</source>
        <translation>หนาม</translation>
    </message>
    <message>
        <source>Stand</source>
        <translation>ขาตั้ง</translation>
    </message>
    <message>
        <source>Steel</source>
        <translation>สเตนเลส</translation>
    </message>
    <message>
        <source>Stem</source>
        <translation>ก้าน</translation>
    </message>
    <message>
        <source>Stringer</source>
        <translation>แม่บันได</translation>
    </message>
    <message>
        <source>Tap</source>
        <translation>ก๊อกน้ำ</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>ธรณีประตู</translation>
    </message>
    <message>
        <source>Throw</source>
        <translation>ผ้าคลุม</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>ด้านบน</translation>
    </message>
    <message>
        <source>Towel</source>
        <translation>ผ้าเช็ดตัว</translation>
    </message>
    <message>
        <source>Tray</source>
        <translation>ถาด</translation>
    </message>
    <message>
        <source>Tread</source>
        <translation>ลูกนอน</translation>
    </message>
    <message>
        <source>Tub</source>
        <translation>อ่าง</translation>
    </message>
    <message>
        <source>Vase</source>
        <translation>แจกัน</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>ผนัง</translation>
    </message>
    <message>
        <source>Wax</source>
        <translation>ขี้ผึ้ง</translation>
    </message>
    <message>
        <source>Wick</source>
        <translation>ไส้เทียน</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>ไม้</translation>
    </message>
    <message>
        <source>Worktop</source>
        <translation>ท็อปเคาน์เตอร์</translation>
    </message>
    <message>
        <source>Thickness of the top</source>
        <translation>ความหนาท็อป</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>ขา</translation>
    </message>
    <message>
        <source>Bars</source>
        <translation>ซี่</translation>
    </message>
    <message>
        <source>Stems</source>
        <translation>ก้าน</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>ใบ</translation>
    </message>
    <message>
        <source>Fronds</source>
        <translation>ทางใบ</translation>
    </message>
    <message>
        <source>Flowers</source>
        <translation>ดอกไม้</translation>
    </message>
    <message>
        <source>Doors</source>
        <translation>จำนวนบานประตู</translation>
    </message>
    <message>
        <source>Drawers</source>
        <translation>ลิ้นชัก</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>คอลัมน์</translation>
    </message>
    <message>
        <source>Seat height</source>
        <translation>ความสูงที่นั่ง</translation>
    </message>
    <message>
        <source>Width of the arms</source>
        <translation>ความกว้างที่วางแขน</translation>
    </message>
    <message>
        <source>Spindles</source>
        <translation>ซี่พนัก</translation>
    </message>
    <message>
        <source>Arms</source>
        <translation>แขน</translation>
    </message>
    <message>
        <source>Spots</source>
        <translation>ดวงไฟ</translation>
    </message>
    <message>
        <source>Candles</source>
        <translation>เทียน</translation>
    </message>
    <message>
        <source>Mirror door number</source>
        <translation>บานกระจกบานที่</translation>
    </message>
    <message>
        <source>Shelves</source>
        <translation>ชั้นวาง</translation>
    </message>
    <message>
        <source>Flaps</source>
        <translation>บานพับเปิด</translation>
    </message>
    <message>
        <source>Panes across</source>
        <translation>ช่องกระจกแนวนอน</translation>
    </message>
    <message>
        <source>Panes up</source>
        <translation>ช่องกระจกแนวตั้ง</translation>
    </message>
    <message>
        <source>How full of books</source>
        <translation>ความแน่นของหนังสือ</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>แถว</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>แผ่นไม้</translation>
    </message>
    <message>
        <source>Sashes</source>
        <translation>จำนวนบาน</translation>
    </message>
    <message>
        <source>Basins</source>
        <translation>จำนวนอ่าง</translation>
    </message>
    <message>
        <source>Height of the bed</source>
        <translation>ความสูงเตียง</translation>
    </message>
    <message>
        <source>Height of the foot</source>
        <translation>ความสูงปลายเตียง</translation>
    </message>
    <message>
        <source>Height of the mattress</source>
        <translation>ความสูงที่นอน</translation>
    </message>
    <message>
        <source>Width of the border</source>
        <translation>ความกว้างขอบ</translation>
    </message>
    <message>
        <source>How far open</source>
        <translation>เปิดกว้างเท่าใด</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>แผง</translation>
    </message>
    <message>
        <source>How far it hangs down</source>
        <translation>ทิ้งชายยาวเท่าใด</translation>
    </message>
    <message>
        <source>Width of the mat</source>
        <translation>ความกว้างกระดาษรองภาพ</translation>
    </message>
    <message>
        <source>Fruits</source>
        <translation>ผลไม้</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>หมุน</translation>
    </message>
    <message>
        <source>Width of the flight</source>
        <translation>ความกว้างบันได</translation>
    </message>
    <message>
        <source>Blades</source>
        <translation>ใบพัด</translation>
    </message>
    <message>
        <source>General</source>
        <translation>ทั่วไป</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>ชื่อ</translation>
    </message>
    <message>
        <source>Change name</source>
        <translation>เปลี่ยนชื่อ</translation>
    </message>
    <message>
        <source>How it is called in lists and on the plan.</source>
        <translation>ชื่อที่แสดงในรายการและบนแปลน</translation>
    </message>
    <message>
        <source>Name on the plan</source>
        <translation>แสดงชื่อบนแปลน</translation>
    </message>
    <message>
        <source>Show name</source>
        <translation>แสดงชื่อ</translation>
    </message>
    <message>
        <source>Writes the name over the piece on the plan.</source>
        <translation>เขียนชื่อไว้บนชิ้นนี้ในแปลน</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>แสดง</translation>
    </message>
    <message>
        <source>Change visibility</source>
        <translation>เปลี่ยนการแสดง</translation>
    </message>
    <message>
        <source>Hidden pieces are on no plan and in no picture.</source>
        <translation>ชิ้นที่ซ่อนจะไม่อยู่บนแปลนและไม่อยู่ในภาพ</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>ล็อก</translation>
    </message>
    <message>
        <source>Change lock</source>
        <translation>เปลี่ยนการล็อก</translation>
    </message>
    <message>
        <source>A locked piece is not moved by the pointer.</source>
        <translation>ชิ้นที่ล็อกจะย้ายด้วยเมาส์ไม่ได้</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>ตำแหน่ง</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>ย้าย</translation>
    </message>
    <message>
        <source>Its middle, to the right of the origin.</source>
        <translation>จุดกึ่งกลาง วัดไปทางขวาจากจุดกำเนิด</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Its middle, up the plan from the origin.</source>
        <translation>จุดกึ่งกลาง วัดขึ้นไปบนแปลนจากจุดกำเนิด</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>ระดับจากพื้น</translation>
    </message>
    <message>
        <source>Raise</source>
        <translation>ยกระดับ</translation>
    </message>
    <message>
        <source>Its base above the floor; of a window the height of its sill.</source>
        <translation>ความสูงของฐานเหนือพื้น ถ้าเป็นหน้าต่างคือระดับขอบล่าง</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>ขนาด</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>กว้าง</translation>
    </message>
    <message>
        <source>Change width</source>
        <translation>เปลี่ยนความกว้าง</translation>
    </message>
    <message>
        <source>From its left to its right. Sums are welcome: 120+15.</source>
        <translation>จากซ้ายถึงขวา พิมพ์ผลบวกได้ เช่น 120+15</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>ลึก</translation>
    </message>
    <message>
        <source>Change depth</source>
        <translation>เปลี่ยนความลึก</translation>
    </message>
    <message>
        <source>From its front to its back.</source>
        <translation>จากด้านหน้าถึงด้านหลัง</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>สูง</translation>
    </message>
    <message>
        <source>Change height</source>
        <translation>เปลี่ยนความสูง</translation>
    </message>
    <message>
        <source>From its base to its top.</source>
        <translation>จากฐานถึงยอด</translation>
    </message>
    <message>
        <source>Keep proportions</source>
        <translation>คงสัดส่วน</translation>
    </message>
    <message>
        <source>The other two sizes change along.</source>
        <translation>อีกสองด้านเปลี่ยนตามไปด้วย</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>กลับด้าน</translation>
    </message>
    <message>
        <source>Left and right exchanged.</source>
        <translation>สลับซ้ายขวา</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>การหมุน</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>มุม</translation>
    </message>
    <message>
        <source>Counter-clockwise on the plan, in degrees.</source>
        <translation>ทวนเข็มนาฬิกาบนแปลน เป็นองศา</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>เอนหน้า-หลัง</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>เอียง</translation>
    </message>
    <message>
        <source>Tilted forwards: lifts its back.</source>
        <translation>เอนไปข้างหน้า: ด้านหลังยกขึ้น</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>เอียงข้าง</translation>
    </message>
    <message>
        <source>Tilted to its side.</source>
        <translation>เอียงไปด้านข้าง</translation>
    </message>
    <message>
        <source>Price and origin</source>
        <translation>ราคาและที่มา</translation>
    </message>
    <message>
        <source>Price</source>
        <translation>ราคา</translation>
    </message>
    <message>
        <source>Change price</source>
        <translation>เปลี่ยนราคา</translation>
    </message>
    <message>
        <source>Of one piece, in the home&apos;s currency; empty: not known.</source>
        <translation>ราคาต่อชิ้นเป็นสกุลเงินของบ้านนี้ ว่าง: ไม่ทราบ</translation>
    </message>
    <message>
        <source>Together</source>
        <translation>รวม</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>หมายเหตุ</translation>
    </message>
    <message>
        <source>Change note</source>
        <translation>เปลี่ยนหมายเหตุ</translation>
    </message>
    <message>
        <source>Anything to remember about it: maker, order number.</source>
        <translation>สิ่งที่ควรจำ เช่น ผู้ผลิต เลขที่สั่งซื้อ</translation>
    </message>
    <message>
        <source>Creator</source>
        <translation>ผู้สร้าง</translation>
    </message>
    <message>
        <source>Who made the model.</source>
        <translation>ผู้สร้างโมเดล</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>สัญญาอนุญาต</translation>
    </message>
    <message>
        <source>Under which terms the model may be passed on.</source>
        <translation>เงื่อนไขในการส่งต่อโมเดล</translation>
    </message>
    <message>
        <source>Lacquer</source>
        <translation>สีพ่น</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>สีทา</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>พื้น</translation>
    </message>
    <message>
        <source>Stone</source>
        <translation>หิน</translation>
    </message>
    <message>
        <source>Tiles and ceramic</source>
        <translation>กระเบื้องและเซรามิก</translation>
    </message>
    <message>
        <source>Plastic</source>
        <translation>พลาสติก</translation>
    </message>
    <message>
        <source>Plants</source>
        <translation>ต้นไม้</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>รูปภาพ</translation>
    </message>
    <message>
        <source>What is on the clipboard cannot be pasted: %1</source>
        <translation>วางสิ่งที่อยู่ในคลิปบอร์ดไม่ได้: %1</translation>
    </message>
    <message>
        <source>The selection cannot be copied: %1</source>
        <translation>คัดลอกสิ่งที่เลือกไม่ได้: %1</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>ตัด</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>วาง</translation>
    </message>
    <message>
        <source>Paste style</source>
        <translation>วางลักษณะ</translation>
    </message>
    <message>
        <source>Remove background picture</source>
        <translation>เอาภาพพื้นหลังออก</translation>
    </message>
    <message>
        <source>Show background picture</source>
        <translation>แสดงภาพพื้นหลัง</translation>
    </message>
    <message>
        <source>Background picture</source>
        <translation>ภาพพื้นหลัง</translation>
    </message>
    <message>
        <source>Change level</source>
        <translation>เปลี่ยนชั้น</translation>
    </message>
    <message>
        <source>Compass and place</source>
        <translation>เข็มทิศและสถานที่</translation>
    </message>
    <message>
        <source>Title and notes</source>
        <translation>ชื่อเรื่องและบันทึก</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2</source>
        <translation>เปิด %1 ไม่ได้: %2</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>บันทึก %1 แล้ว</translation>
    </message>
    <message>
        <source>%1 could not be saved: %2</source>
        <translation>บันทึก %1 ไม่ได้: %2</translation>
    </message>
    <message>
        <source>No safety copy of this home can be kept: %1</source>
        <translation>เก็บสำเนาสำรองของบ้านนี้ไม่ได้: %1</translation>
    </message>
    <message>
        <source>%1: %2 (%3 times)</source>
        <translation>%1: %2 (%3 ครั้ง)</translation>
    </message>
    <message>
        <source>… and %1 more of the kind</source>
        <translation>… และอีก %1 รายการทำนองเดียวกัน</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>เปิด %1 แล้ว</translation>
    </message>
    <message>
        <source>Opened %1; some of it had to be mended or left out: see the messages</source>
        <translation>เปิด %1 แล้ว บางส่วนต้องซ่อมหรือตัดออก ดูที่ข้อความ</translation>
    </message>
    <message>
        <source>Saved a compact copy as %1</source>
        <translation>บันทึกสำเนาแบบย่อเป็น %1 แล้ว</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>เลิกทำ(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>ทำซ้ำ(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;New room…</source>
        <translation>ห้องใหม่(&amp;N)…</translation>
    </message>
    <message>
        <source>Starts an empty room: asks for its size along X, Y and Z</source>
        <translation>เริ่มห้องว่างใหม่ โดยถามขนาดตามแกน X, Y และ Z</translation>
    </message>
    <message>
        <source>New</source>
        <translation>ใหม่</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>หน้าต่างใหม่(&amp;W)</translation>
    </message>
    <message>
        <source>Another window, to work on two homes and copy between them</source>
        <translation>เปิดอีกหน้าต่าง เพื่อทำสองบ้านพร้อมกันและคัดลอกข้ามกัน</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>เปิด(&amp;O)…</translation>
    </message>
    <message>
        <source>Reads a home of IDAP (.idap) or Sweet Home 3D (.sh3d)</source>
        <translation>อ่านบ้านของ IDAP (.idap) หรือ Sweet Home 3D (.sh3d)</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>โหลด</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>บันทึก(&amp;S)</translation>
    </message>
    <message>
        <source>Writes the home to its file</source>
        <translation>บันทึกบ้านลงไฟล์เดิม</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>บันทึก</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>บันทึกเป็น(&amp;A)…</translation>
    </message>
    <message>
        <source>Writes the home to another file and goes on with that</source>
        <translation>บันทึกบ้านเป็นไฟล์อื่น แล้วทำต่อกับไฟล์นั้น</translation>
    </message>
    <message>
        <source>Save a &amp;compact copy…</source>
        <translation>บันทึกสำเนาแบบย่อ(&amp;C)…</translation>
    </message>
    <message>
        <source>Writes a copy without the models and pictures that nothing uses</source>
        <translation>บันทึกสำเนาโดยตัดโมเดลและรูปที่ไม่ได้ใช้ออก</translation>
    </message>
    <message>
        <source>Export the &amp;furniture list…</source>
        <translation>ส่งออกรายการเฟอร์นิเจอร์(&amp;F)…</translation>
    </message>
    <message>
        <source>Writes the list as a table (CSV) for a spreadsheet</source>
        <translation>บันทึกรายการเป็นตาราง (CSV) สำหรับโปรแกรมตารางคำนวณ</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>พิมพ์(&amp;P)…</translation>
    </message>
    <message>
        <source>Prints the plan to scale, on paper or into a PDF</source>
        <translation>พิมพ์แปลนตามมาตราส่วน ลงกระดาษหรือเป็น PDF</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>พิมพ์</translation>
    </message>
    <message>
        <source>P&amp;references…</source>
        <translation>การตั้งค่า(&amp;R)…</translation>
    </message>
    <message>
        <source>Units, language, light or dark, snapping and new walls</source>
        <translation>หน่วย ภาษา ธีมสว่างหรือมืด การสแนป และผนังใหม่</translation>
    </message>
    <message>
        <source>&amp;Close the home</source>
        <translation>ปิดบ้าน(&amp;C)</translation>
    </message>
    <message>
        <source>Back to the first page; asks about unsaved work</source>
        <translation>กลับไปหน้าแรก ถามก่อนถ้ายังไม่ได้บันทึก</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>ออก(&amp;Q)</translation>
    </message>
    <message>
        <source>Leaves the program; asks about unsaved work</source>
        <translation>ออกจากโปรแกรม ถามก่อนถ้ายังไม่ได้บันทึก</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>ออก</translation>
    </message>
    <message>
        <source>Takes back the last step; there is no limit</source>
        <translation>ย้อนกลับหนึ่งขั้น ได้ไม่จำกัด</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>เลิกทำ</translation>
    </message>
    <message>
        <source>Does again what was taken back</source>
        <translation>ทำซ้ำสิ่งที่เพิ่งเลิกทำ</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>ทำซ้ำ</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>ตัด(&amp;T)</translation>
    </message>
    <message>
        <source>Moves the selection to the clipboard</source>
        <translation>ย้ายสิ่งที่เลือกไปไว้ในคลิปบอร์ด</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>คัดลอก(&amp;C)</translation>
    </message>
    <message>
        <source>Copies the selection, also for other windows</source>
        <translation>คัดลอกสิ่งที่เลือก ใช้กับหน้าต่างอื่นได้ด้วย</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>วาง(&amp;P)</translation>
    </message>
    <message>
        <source>Puts what was copied beside its original</source>
        <translation>วางสิ่งที่คัดลอกไว้ข้างต้นฉบับ</translation>
    </message>
    <message>
        <source>Paste in p&amp;lace</source>
        <translation>วางที่เดิม(&amp;L)</translation>
    </message>
    <message>
        <source>Puts what was copied where its original is, on this level</source>
        <translation>วางสิ่งที่คัดลอกตรงตำแหน่งของต้นฉบับบนชั้นนี้</translation>
    </message>
    <message>
        <source>Paste into the &amp;group</source>
        <translation>วางลงในกลุ่ม(&amp;G)</translation>
    </message>
    <message>
        <source>What was copied becomes part of the selected group</source>
        <translation>สิ่งที่คัดลอกจะรวมเข้าในกลุ่มที่เลือก</translation>
    </message>
    <message>
        <source>Paste st&amp;yle</source>
        <translation>วางลักษณะ(&amp;Y)</translation>
    </message>
    <message>
        <source>Gives the selection the finishes of what was copied</source>
        <translation>ให้สิ่งที่เลือกใช้ผิววัสดุของสิ่งที่คัดลอก</translation>
    </message>
    <message>
        <source>P&amp;roperties</source>
        <translation>คุณสมบัติ(&amp;R)</translation>
    </message>
    <message>
        <source>Goes to the numbers and finishes of the selection</source>
        <translation>ไปที่ตัวเลขและผิววัสดุของสิ่งที่เลือก</translation>
    </message>
    <message>
        <source>Property</source>
        <translation>คุณสมบัติ</translation>
    </message>
    <message>
        <source>&amp;Eraser</source>
        <translation>ยางลบ(&amp;E)</translation>
    </message>
    <message>
        <source>Deletes what is selected; with nothing selected, what is clicked</source>
        <translation>ลบสิ่งที่เลือก ถ้าไม่ได้เลือกอะไร จะลบสิ่งที่คลิก</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>ยางลบ</translation>
    </message>
    <message>
        <source>&amp;Find in the catalog</source>
        <translation>ค้นหาในแค็ตตาล็อก(&amp;F)</translation>
    </message>
    <message>
        <source>Search for furniture by its name; Enter places it</source>
        <translation>ค้นหาเฟอร์นิเจอร์ตามชื่อ กด Enter เพื่อวาง</translation>
    </message>
    <message>
        <source>&amp;Import furniture…</source>
        <translation>นำเข้าเฟอร์นิเจอร์(&amp;I)…</translation>
    </message>
    <message>
        <source>Adds a model of your own, or a library of furniture, to the catalog</source>
        <translation>เพิ่มโมเดลของคุณเองหรือคลังเฟอร์นิเจอร์ลงในแค็ตตาล็อก</translation>
    </message>
    <message>
        <source>&amp;Title and notes…</source>
        <translation>ชื่อเรื่องและบันทึก(&amp;T)…</translation>
    </message>
    <message>
        <source>The title on prints, and notes about the home</source>
        <translation>ชื่อเรื่องบนงานพิมพ์ และบันทึกเกี่ยวกับบ้าน</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>ข้อความ</translation>
    </message>
    <message>
        <source>&amp;Compass and place…</source>
        <translation>เข็มทิศและสถานที่(&amp;C)…</translation>
    </message>
    <message>
        <source>Where north is, the town, the date and the hour: they set the sun</source>
        <translation>ทิศเหนือ เมือง วันที่ และเวลา ซึ่งกำหนดตำแหน่งดวงอาทิตย์</translation>
    </message>
    <message>
        <source>&amp;Background picture…</source>
        <translation>ภาพพื้นหลัง(&amp;B)…</translation>
    </message>
    <message>
        <source>A scanned plan under the drawing, to draw it over</source>
        <translation>แปลนสแกนวางไว้ใต้แบบ เพื่อเขียนทับ</translation>
    </message>
    <message>
        <source>Level &amp;properties…</source>
        <translation>คุณสมบัติชั้น(&amp;P)…</translation>
    </message>
    <message>
        <source>Name, elevation, height and floor of this level</source>
        <translation>ชื่อ ระดับ ความสูง และพื้นของชั้นนี้</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>ซูมเข้า(&amp;I)</translation>
    </message>
    <message>
        <source>Nearer; the wheel does it under the pointer</source>
        <translation>เข้าใกล้ ใช้ล้อเมาส์ที่ตำแหน่งเมาส์ได้</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>ซูมออก(&amp;O)</translation>
    </message>
    <message>
        <source>Farther; the wheel does it under the pointer</source>
        <translation>ถอยออก ใช้ล้อเมาส์ที่ตำแหน่งเมาส์ได้</translation>
    </message>
    <message>
        <source>Zoom to &amp;fit</source>
        <translation>ซูมพอดี(&amp;F)</translation>
    </message>
    <message>
        <source>All of the home, in every plane</source>
        <translation>เห็นทั้งบ้านในทุกระนาบ</translation>
    </message>
    <message>
        <source>Zoom to the &amp;selection</source>
        <translation>ซูมที่สิ่งที่เลือก(&amp;S)</translation>
    </message>
    <message>
        <source>What is selected, as large as it fits</source>
        <translation>ขยายสิ่งที่เลือกให้ใหญ่ที่สุดเท่าที่พอดี</translation>
    </message>
    <message>
        <source>Only plan &amp;X-Y</source>
        <translation>แปลน X-Y เท่านั้น(&amp;X)</translation>
    </message>
    <message>
        <source>The plan from above, alone; again: all views</source>
        <translation>แปลนจากด้านบนมุมมองเดียว กดอีกครั้งเพื่อดูทุกมุมมอง</translation>
    </message>
    <message>
        <source>Only elevation X-&amp;Z</source>
        <translation>รูปด้าน X-Z เท่านั้น(&amp;Z)</translation>
    </message>
    <message>
        <source>The view from the front, alone; again: all views</source>
        <translation>มุมมองด้านหน้ามุมมองเดียว กดอีกครั้งเพื่อดูทุกมุมมอง</translation>
    </message>
    <message>
        <source>Only elevation &amp;Y-Z</source>
        <translation>รูปด้าน Y-Z เท่านั้น(&amp;Y)</translation>
    </message>
    <message>
        <source>The view from the right, alone; again: all views</source>
        <translation>มุมมองด้านขวามุมมองเดียว กดอีกครั้งเพื่อดูทุกมุมมอง</translation>
    </message>
    <message>
        <source>Only the &amp;picture</source>
        <translation>ภาพเรนเดอร์เท่านั้น(&amp;P)</translation>
    </message>
    <message>
        <source>The ray-traced picture, alone; again: all views</source>
        <translation>ภาพเรนเดอร์มุมมองเดียว กดอีกครั้งเพื่อดูทุกมุมมอง</translation>
    </message>
    <message>
        <source>&amp;All views</source>
        <translation>ทุกมุมมอง(&amp;A)</translation>
    </message>
    <message>
        <source>The three planes and the picture together</source>
        <translation>ทั้งสามระนาบและภาพเรนเดอร์พร้อมกัน</translation>
    </message>
    <message>
        <source>&amp;Maximise this view</source>
        <translation>ขยายมุมมองนี้เต็มจอ(&amp;M)</translation>
    </message>
    <message>
        <source>The view in use alone, or all again; so does a double click on its caption</source>
        <translation>เฉพาะมุมมองที่ใช้อยู่ หรือกลับเป็นทั้งหมด ดับเบิลคลิกที่หัวมุมมองก็ได้</translation>
    </message>
    <message>
        <source>&amp;Ray trace</source>
        <translation>เรนเดอร์(&amp;R)</translation>
    </message>
    <message>
        <source>Makes the picture of the chosen point of view, while you go on working</source>
        <translation>สร้างภาพจากมุมกล้องที่เลือก ระหว่างนั้นทำงานต่อได้</translation>
    </message>
    <message>
        <source>Ray Trace</source>
        <translation>เรนเดอร์</translation>
    </message>
    <message>
        <source>&amp;Catalog</source>
        <translation>แค็ตตาล็อก(&amp;C)</translation>
    </message>
    <message>
        <source>The furniture, on the left</source>
        <translation>เฟอร์นิเจอร์ทางด้านซ้าย</translation>
    </message>
    <message>
        <source>&amp;Properties</source>
        <translation>คุณสมบัติ(&amp;P)</translation>
    </message>
    <message>
        <source>The selection in numbers, on the right</source>
        <translation>ตัวเลขของสิ่งที่เลือก ทางด้านขวา</translation>
    </message>
    <message>
        <source>&amp;Lists</source>
        <translation>รายการ(&amp;L)</translation>
    </message>
    <message>
        <source>Furniture, points of view and messages, below</source>
        <translation>เฟอร์นิเจอร์ มุมกล้อง และข้อความ ด้านล่าง</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>ปุ่มลัด(&amp;K)</translation>
    </message>
    <message>
        <source>Every key and what it does</source>
        <translation>ปุ่มลัดทั้งหมดและหน้าที่</translation>
    </message>
    <message>
        <source>&amp;About IDAP</source>
        <translation>เกี่ยวกับ IDAP(&amp;A)</translation>
    </message>
    <message>
        <source>Version, licence, and whose work is in it</source>
        <translation>รุ่น สัญญาอนุญาต และผลงานที่นำมาใช้</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ไฟล์(&amp;F)</translation>
    </message>
    <message>
        <source>New from a &amp;template</source>
        <translation>สร้างจากแม่แบบ(&amp;T)</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>เปิดล่าสุด(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>แก้ไข(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Draw</source>
        <translation>เขียนแบบ(&amp;D)</translation>
    </message>
    <message>
        <source>F&amp;urniture</source>
        <translation>เฟอร์นิเจอร์(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>แปลน(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Walls</source>
        <translation>ผนัง(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Levels</source>
        <translation>ชั้น(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>มุมมอง(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ช่วยเหลือ(&amp;H)</translation>
    </message>
    <message>
        <source>Exported the furniture list as %1</source>
        <translation>ส่งออกรายการเฟอร์นิเจอร์เป็น %1 แล้ว</translation>
    </message>
    <message>
        <source>The furniture list could not be written: %1</source>
        <translation>เขียนรายการเฟอร์นิเจอร์ไม่ได้: %1</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>จัดแนว</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>กระจาย</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>ซ้าย</translation>
    </message>
    <message>
        <source>Puts the left edges of the selected pieces in line with the first one&apos;s</source>
        <translation>จัดขอบซ้ายของชิ้นที่เลือกให้ตรงกับชิ้นแรก</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>กึ่งกลาง</translation>
    </message>
    <message>
        <source>Puts the middles of the selected pieces above each other, as the first one stands</source>
        <translation>จัดจุดกึ่งกลางให้ตรงกันในแนวตั้ง ตามชิ้นแรก</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>ขวา</translation>
    </message>
    <message>
        <source>Puts the right edges of the selected pieces in line with the first one&apos;s</source>
        <translation>จัดขอบขวาของชิ้นที่เลือกให้ตรงกับชิ้นแรก</translation>
    </message>
    <message>
        <source>Puts the upper edges on the plan in line with the first one&apos;s</source>
        <translation>จัดขอบบนบนแปลนให้ตรงกับชิ้นแรก</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>กลาง</translation>
    </message>
    <message>
        <source>Puts the middles of the selected pieces beside each other, as the first one stands</source>
        <translation>จัดจุดกึ่งกลางให้ตรงกันในแนวนอน ตามชิ้นแรก</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>ด้านล่าง</translation>
    </message>
    <message>
        <source>Puts the lower edges on the plan in line with the first one&apos;s</source>
        <translation>จัดขอบล่างบนแปลนให้ตรงกับชิ้นแรก</translation>
    </message>
    <message>
        <source>Front side</source>
        <translation>ด้านหน้า</translation>
    </message>
    <message>
        <source>Puts the pieces in line with the front of the first one, however it is turned</source>
        <translation>จัดให้ตรงแนวด้านหน้าของชิ้นแรก ไม่ว่าชิ้นนั้นจะหันไปทางใด</translation>
    </message>
    <message>
        <source>Back side</source>
        <translation>ด้านหลัง</translation>
    </message>
    <message>
        <source>Puts the pieces in line with the back of the first one, however it is turned</source>
        <translation>จัดให้ตรงแนวด้านหลังของชิ้นแรก ไม่ว่าชิ้นนั้นจะหันไปทางใด</translation>
    </message>
    <message>
        <source>Left side</source>
        <translation>ด้านซ้าย</translation>
    </message>
    <message>
        <source>Puts the pieces in line with the left side of the first one, however it is turned</source>
        <translation>จัดให้ตรงแนวด้านซ้ายของชิ้นแรก ไม่ว่าชิ้นนั้นจะหันไปทางใด</translation>
    </message>
    <message>
        <source>Right side</source>
        <translation>ด้านขวา</translation>
    </message>
    <message>
        <source>Puts the pieces in line with the right side of the first one, however it is turned</source>
        <translation>จัดให้ตรงแนวด้านขวาของชิ้นแรก ไม่ว่าชิ้นนั้นจะหันไปทางใด</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>เรียงชิดกัน</translation>
    </message>
    <message>
        <source>Puts the pieces in a row without gaps, their backs in line with the first one&apos;s</source>
        <translation>เรียงเป็นแถวชิดกัน ให้ด้านหลังตรงกับชิ้นแรก</translation>
    </message>
    <message>
        <source>Horizontally</source>
        <translation>แนวนอน</translation>
    </message>
    <message>
        <source>Makes the gaps from left to right equal; the outermost pieces stay</source>
        <translation>จัดช่องว่างจากซ้ายไปขวาให้เท่ากัน ชิ้นริมสุดอยู่ที่เดิม</translation>
    </message>
    <message>
        <source>Vertically</source>
        <translation>แนวตั้ง</translation>
    </message>
    <message>
        <source>Makes the gaps from bottom to top equal; the outermost pieces stay</source>
        <translation>จัดช่องว่างจากล่างขึ้นบนให้เท่ากัน ชิ้นริมสุดอยู่ที่เดิม</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>ลบ</translation>
    </message>
    <message>
        <source>Locked, and therefore still there: %1</source>
        <translation>ล็อกอยู่ จึงไม่ถูกลบ: %1</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>ทำสำเนา</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>หมุน</translation>
    </message>
    <message>
        <source>Takes away what is selected. Undo brings it back</source>
        <translation>ลบสิ่งที่เลือก เลิกทำเพื่อเอากลับมาได้</translation>
    </message>
    <message>
        <source>Puts a copy of what is selected beside it, ready to be moved</source>
        <translation>วางสำเนาของสิ่งที่เลือกไว้ข้าง ๆ พร้อมให้ย้าย</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>เลือกทั้งหมด</translation>
    </message>
    <message>
        <source>Selects all that can be selected on this level</source>
        <translation>เลือกทุกอย่างที่เลือกได้บนชั้นนี้</translation>
    </message>
    <message>
        <source>Select all on all levels</source>
        <translation>เลือกทั้งหมดทุกชั้น</translation>
    </message>
    <message>
        <source>Selects the whole home, to move or copy it as one</source>
        <translation>เลือกทั้งบ้าน เพื่อย้ายหรือคัดลอกไปพร้อมกัน</translation>
    </message>
    <message>
        <source>Rotate left</source>
        <translation>หมุนซ้าย</translation>
    </message>
    <message>
        <source>Turns what is selected by 90 degrees counter-clockwise about its middle; a door or window in its wall to the other side</source>
        <translation>หมุนสิ่งที่เลือก 90 องศาทวนเข็มนาฬิการอบจุดกึ่งกลาง ประตูหน้าต่างจะพลิกไปอีกด้านของผนัง</translation>
    </message>
    <message>
        <source>Rotate right</source>
        <translation>หมุนขวา</translation>
    </message>
    <message>
        <source>Turns what is selected by 90 degrees clockwise about its middle; a door or window in its wall to the other side</source>
        <translation>หมุนสิ่งที่เลือก 90 องศาตามเข็มนาฬิการอบจุดกึ่งกลาง ประตูหน้าต่างจะพลิกไปอีกด้านของผนัง</translation>
    </message>
    <message>
        <source>Exchanges left and right: of one piece where it stands, of several about their middle</source>
        <translation>สลับซ้ายขวา: ชิ้นเดียวกลับด้านอยู่กับที่ หลายชิ้นกลับด้านรอบจุดกึ่งกลางร่วม</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>จัดกลุ่ม</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>แยกกลุ่ม</translation>
    </message>
    <message>
        <source>Reset elevation</source>
        <translation>ตั้งระดับใหม่</translation>
    </message>
    <message>
        <source>Put on the floor</source>
        <translation>วางลงพื้น</translation>
    </message>
    <message>
        <source>Switch lamps on</source>
        <translation>เปิดโคมไฟ</translation>
    </message>
    <message>
        <source>Switch lamps off</source>
        <translation>ปิดโคมไฟ</translation>
    </message>
    <message>
        <source>Makes one of the selected pieces, to be moved and turned together</source>
        <translation>รวมชิ้นที่เลือกเป็นหนึ่งเดียว เพื่อย้ายและหมุนไปด้วยกัน</translation>
    </message>
    <message>
        <source>Takes the selected groups apart; their pieces stay where they are</source>
        <translation>แยกกลุ่มที่เลือกออก ชิ้นต่าง ๆ อยู่ที่เดิม</translation>
    </message>
    <message>
        <source>Lets the selected pieces stand on what is under them: a table or the floor</source>
        <translation>ให้ชิ้นที่เลือกตั้งบนสิ่งที่อยู่ข้างใต้ เช่น โต๊ะหรือพื้น</translation>
    </message>
    <message>
        <source>Lowers or raises the selected pieces to the floor of their level</source>
        <translation>ลดหรือยกชิ้นที่เลือกให้อยู่บนพื้นของชั้นนั้น</translation>
    </message>
    <message>
        <source>Switches the selected lamps on, or all of the home when nothing is selected</source>
        <translation>เปิดโคมไฟที่เลือก หรือทั้งบ้านถ้าไม่ได้เลือกอะไร</translation>
    </message>
    <message>
        <source>Switches the selected lamps off, or all of the home when nothing is selected</source>
        <translation>ปิดโคมไฟที่เลือก หรือทั้งบ้านถ้าไม่ได้เลือกอะไร</translation>
    </message>
    <message>
        <source>Add level</source>
        <translation>เพิ่มชั้น</translation>
    </message>
    <message>
        <source>Delete level</source>
        <translation>ลบชั้น</translation>
    </message>
    <message>
        <source>Move level up</source>
        <translation>เลื่อนชั้นขึ้น</translation>
    </message>
    <message>
        <source>Move level down</source>
        <translation>เลื่อนชั้นลง</translation>
    </message>
    <message>
        <source>Show level</source>
        <translation>แสดงชั้น</translation>
    </message>
    <message>
        <source>Hide level</source>
        <translation>ซ่อนชั้น</translation>
    </message>
    <message>
        <source>Show only this level</source>
        <translation>แสดงชั้นนี้ชั้นเดียว</translation>
    </message>
    <message>
        <source>Show all levels</source>
        <translation>แสดงทุกชั้น</translation>
    </message>
    <message>
        <source>Add level above</source>
        <translation>เพิ่มชั้นด้านบน</translation>
    </message>
    <message>
        <source>Adds a storey on top of the current one; what is above moves up</source>
        <translation>เพิ่มชั้นเหนือชั้นนี้ ชั้นที่อยู่เหนือขึ้นไปจะเลื่อนขึ้น</translation>
    </message>
    <message>
        <source>Add level at same elevation</source>
        <translation>เพิ่มชั้นที่ระดับเดียวกัน</translation>
    </message>
    <message>
        <source>Adds a level at the height of the current one, for a variant or another part of the house</source>
        <translation>เพิ่มชั้นที่ระดับเดียวกับชั้นนี้ สำหรับแบบทางเลือกหรืออีกส่วนของบ้าน</translation>
    </message>
    <message>
        <source>Exchanges the current level with the one above it</source>
        <translation>สลับชั้นนี้กับชั้นที่อยู่เหนือขึ้นไป</translation>
    </message>
    <message>
        <source>Exchanges the current level with the one below it</source>
        <translation>สลับชั้นนี้กับชั้นที่อยู่ต่ำลงไป</translation>
    </message>
    <message>
        <source>Level visible</source>
        <translation>แสดงชั้นนี้</translation>
    </message>
    <message>
        <source>Shows or hides the current level in pictures</source>
        <translation>แสดงหรือซ่อนชั้นนี้ในภาพ</translation>
    </message>
    <message>
        <source>Only this level</source>
        <translation>เฉพาะชั้นนี้</translation>
    </message>
    <message>
        <source>Hides all other levels in pictures, to see into this one from above; once more shows them all</source>
        <translation>ซ่อนชั้นอื่นทั้งหมดในภาพ เพื่อมองเห็นชั้นนี้จากด้านบน กดอีกครั้งเพื่อแสดงทั้งหมด</translation>
    </message>
    <message>
        <source>Takes away the current level with all that stands on it. Undo brings it back</source>
        <translation>ลบชั้นนี้พร้อมทุกอย่างบนชั้น เลิกทำเพื่อเอากลับมาได้</translation>
    </message>
    <message>
        <source>Flip plan horizontally</source>
        <translation>พลิกแปลนแนวนอน</translation>
    </message>
    <message>
        <source>Flip plan vertically</source>
        <translation>พลิกแปลนแนวตั้ง</translation>
    </message>
    <message>
        <source>Lock base plan</source>
        <translation>ล็อกแปลนพื้นฐาน</translation>
    </message>
    <message>
        <source>Walls, rooms, doors, windows, dimensions and labels cannot be selected then: furniture is arranged without moving them by mistake</source>
        <translation>ผนัง ห้อง ประตู หน้าต่าง เส้นบอกขนาด และข้อความจะเลือกไม่ได้ เพื่อจัดเฟอร์นิเจอร์โดยไม่เผลอย้าย</translation>
    </message>
    <message>
        <source>Flip horizontally</source>
        <translation>พลิกแนวนอน</translation>
    </message>
    <message>
        <source>Exchanges left and right of the whole plan, on all levels</source>
        <translation>สลับซ้ายขวาทั้งแปลน ทุกชั้น</translation>
    </message>
    <message>
        <source>Flip vertically</source>
        <translation>พลิกแนวตั้ง</translation>
    </message>
    <message>
        <source>Exchanges top and bottom of the whole plan, on all levels</source>
        <translation>สลับบนล่างทั้งแปลน ทุกชั้น</translation>
    </message>
    <message>
        <source>Snapping</source>
        <translation>สแนป</translation>
    </message>
    <message>
        <source>What is drawn or moved jumps to ends, lines, walls, right angles and other pieces; hold Alt to suspend it</source>
        <translation>สิ่งที่เขียนหรือย้ายจะดูดเข้าหาปลายเส้น เส้น ผนัง มุมฉาก และชิ้นอื่น กด Alt ค้างเพื่อพักไว้</translation>
    </message>
    <message>
        <source>Snap to grid</source>
        <translation>สแนปเข้ากริด</translation>
    </message>
    <message>
        <source>What is drawn or moved keeps to the lines of the grid</source>
        <translation>สิ่งที่เขียนหรือย้ายจะอยู่ตามเส้นกริด</translation>
    </message>
    <message>
        <source>Rooms by themselves</source>
        <translation>สร้างห้องอัตโนมัติ</translation>
    </message>
    <message>
        <source>Walls that close an area get a room with a floor and a ceiling at once</source>
        <translation>ผนังที่ล้อมพื้นที่ครบจะกลายเป็นห้องที่มีพื้นและเพดานทันที</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>กริด</translation>
    </message>
    <message>
        <source>Shows the grid under the plans, to judge sizes by</source>
        <translation>แสดงกริดใต้แปลน ไว้กะขนาด</translation>
    </message>
    <message>
        <source>Rulers</source>
        <translation>ไม้บรรทัด</translation>
    </message>
    <message>
        <source>Shows rulers at the top and left of the plans</source>
        <translation>แสดงไม้บรรทัดด้านบนและด้านซ้ายของแปลน</translation>
    </message>
    <message>
        <source>Level below</source>
        <translation>ชั้นที่อยู่ต่ำกว่า</translation>
    </message>
    <message>
        <source>Shows the level below faintly under the current one, to draw walls above walls</source>
        <translation>แสดงชั้นที่อยู่ต่ำกว่าจาง ๆ เพื่อเขียนผนังให้ตรงกับผนังชั้นนั้น</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>ล็อก</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>ปลดล็อก</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>แสดงทั้งหมด</translation>
    </message>
    <message>
        <source>Keeps what is selected where it is: it can be selected, but neither moved nor deleted until it is unlocked</source>
        <translation>ตรึงสิ่งที่เลือกไว้กับที่ เลือกได้แต่ย้ายหรือลบไม่ได้จนกว่าจะปลดล็อก</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>ซ่อน</translation>
    </message>
    <message>
        <source>Takes what is selected out of plans and pictures without deleting it; the furniture list still has it</source>
        <translation>นำสิ่งที่เลือกออกจากแปลนและภาพโดยไม่ลบ ยังอยู่ในรายการเฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>แสดง</translation>
    </message>
    <message>
        <source>Shows what is selected in the list but hidden in the plans</source>
        <translation>แสดงสิ่งที่เลือกในรายการแต่ซ่อนอยู่ในแปลน</translation>
    </message>
    <message>
        <source>Show all hidden</source>
        <translation>แสดงสิ่งที่ซ่อนทั้งหมด</translation>
    </message>
    <message>
        <source>Shows all pieces and groups that were hidden, on every level</source>
        <translation>แสดงทุกชิ้นและทุกกลุ่มที่ซ่อนไว้ ในทุกชั้น</translation>
    </message>
    <message>
        <source>Join walls</source>
        <translation>ต่อผนัง</translation>
    </message>
    <message>
        <source>Split walls</source>
        <translation>แบ่งผนัง</translation>
    </message>
    <message>
        <source>Reverse walls</source>
        <translation>กลับทิศผนัง</translation>
    </message>
    <message>
        <source>Straighten walls</source>
        <translation>ดัดผนังให้ตรง</translation>
    </message>
    <message>
        <source>Walls around room</source>
        <translation>ผนังรอบห้อง</translation>
    </message>
    <message>
        <source>Make rooms</source>
        <translation>สร้างห้อง</translation>
    </message>
    <message>
        <source>Walls close no area here that has no room yet</source>
        <translation>ไม่มีพื้นที่ที่ผนังล้อมครบซึ่งยังไม่เป็นห้อง</translation>
    </message>
    <message>
        <source>Prolongs or shortens the two selected walls to where they meet, so that their corner is closed</source>
        <translation>ยืดหรือหดผนังสองแนวที่เลือกให้มาบรรจบกันเป็นมุมปิด</translation>
    </message>
    <message>
        <source>Split in the middle</source>
        <translation>แบ่งครึ่ง</translation>
    </message>
    <message>
        <source>Makes two walls of each selected one, to move or finish one part alone</source>
        <translation>แบ่งผนังที่เลือกแต่ละแนวเป็นสอง เพื่อย้ายหรือเปลี่ยนผิวทีละส่วน</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>กลับทิศ</translation>
    </message>
    <message>
        <source>Exchanges start and end, left and right of the selected walls; they look as before</source>
        <translation>สลับต้นกับปลาย ซ้ายกับขวาของผนังที่เลือก หน้าตาเหมือนเดิม</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>ดัดให้ตรง</translation>
    </message>
    <message>
        <source>Makes the selected round walls straight again</source>
        <translation>ทำผนังโค้งที่เลือกให้ตรงเหมือนเดิม</translation>
    </message>
    <message>
        <source>Puts walls along the outline of the selected rooms, outside of them</source>
        <translation>สร้างผนังตามขอบของห้องที่เลือก ด้านนอกห้อง</translation>
    </message>
    <message>
        <source>Make rooms of closed areas</source>
        <translation>สร้างห้องจากพื้นที่ปิด</translation>
    </message>
    <message>
        <source>Gives every area that walls close on this level a room with a floor and a ceiling, where it has none yet</source>
        <translation>สร้างห้องที่มีพื้นและเพดานให้ทุกพื้นที่ที่ผนังล้อมครบบนชั้นนี้ซึ่งยังไม่มีห้อง</translation>
    </message>
    <message>
        <source>That cannot be done: %1</source>
        <translation>ทำไม่ได้: %1</translation>
    </message>
    <message>
        <source>Set the scale of the background</source>
        <translation>กำหนดมาตราส่วนภาพพื้นหลัง</translation>
    </message>
    <message>
        <source>Give a length on the scanned plan, and it gets its true size</source>
        <translation>บอกความยาวจริงบนแปลนสแกน แล้วภาพจะได้ขนาดจริง</translation>
    </message>
    <message>
        <source>Click one end of a length that you know on the picture</source>
        <translation>คลิกปลายด้านหนึ่งของระยะที่คุณรู้ความยาวบนภาพ</translation>
    </message>
    <message>
        <source>type the true length</source>
        <translation>พิมพ์ความยาวจริง</translation>
    </message>
    <message>
        <source>done</source>
        <translation>เสร็จ</translation>
    </message>
    <message>
        <source>Move the background</source>
        <translation>ย้ายภาพพื้นหลัง</translation>
    </message>
    <message>
        <source>Drag the scanned plan to where it belongs</source>
        <translation>ลากแปลนสแกนไปยังตำแหน่งที่ถูกต้อง</translation>
    </message>
    <message>
        <source>Drag a point of the picture to where it belongs</source>
        <translation>ลากจุดบนภาพไปยังตำแหน่งที่ถูกต้อง</translation>
    </message>
    <message>
        <source>no snapping</source>
        <translation>ไม่สแนป</translation>
    </message>
    <message>
        <source>Click its other end</source>
        <translation>คลิกปลายอีกด้าน</translation>
    </message>
    <message>
        <source>Type the true length between them, then press Enter</source>
        <translation>พิมพ์ความยาวจริงระหว่างสองจุด แล้วกด Enter</translation>
    </message>
    <message>
        <source>The length must be more than nothing</source>
        <translation>ความยาวต้องมากกว่าศูนย์</translation>
    </message>
    <message>
        <source>True length</source>
        <translation>ความยาวจริง</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>กล้อง</translation>
    </message>
    <message>
        <source>Put a point of view and aim it, for pictures and the live view</source>
        <translation>วางกล้องและเล็งมุม สำหรับภาพเรนเดอร์และมุมมองสด</translation>
    </message>
    <message>
        <source>Press where the eye is and drag to what it looks at</source>
        <translation>กดที่ตำแหน่งตาแล้วลากไปยังสิ่งที่มอง</translation>
    </message>
    <message>
        <source>type the height of the eye</source>
        <translation>พิมพ์ความสูงระดับตา</translation>
    </message>
    <message>
        <source>any angle</source>
        <translation>มุมใดก็ได้</translation>
    </message>
    <message>
        <source>Let go, or click, at what it looks at</source>
        <translation>ปล่อยหรือคลิกที่สิ่งที่มอง</translation>
    </message>
    <message>
        <source>Add camera</source>
        <translation>เพิ่มกล้อง</translation>
    </message>
    <message>
        <source>Eye height</source>
        <translation>ระดับตา</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>เส้นบอกขนาด</translation>
    </message>
    <message>
        <source>Write a length on the plan, or a height beside it</source>
        <translation>บอกความยาวบนแปลน หรือความสูงไว้ข้าง ๆ</translation>
    </message>
    <message>
        <source>Click where the measure starts</source>
        <translation>คลิกจุดเริ่มวัด</translation>
    </message>
    <message>
        <source>type how far beside it is drawn</source>
        <translation>พิมพ์ระยะห่างของเส้น</translation>
    </message>
    <message>
        <source>Click where the measure ends</source>
        <translation>คลิกจุดสิ้นสุดที่วัด</translation>
    </message>
    <message>
        <source>Click where the line is to be drawn</source>
        <translation>คลิกตำแหน่งที่จะวางเส้น</translation>
    </message>
    <message>
        <source>Add dimension</source>
        <translation>เพิ่มเส้นบอกขนาด</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>ระยะเยื้อง</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>ความยาว</translation>
    </message>
    <message>
        <source>Take away what you click; undo brings it back</source>
        <translation>ลบสิ่งที่คลิก เลิกทำเพื่อเอากลับมาได้</translation>
    </message>
    <message>
        <source>Click what is to go, or drag over it</source>
        <translation>คลิกสิ่งที่จะลบ หรือลากผ่าน</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>หยุด</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>ลบ</translation>
    </message>
    <message>
        <source>A click takes this away</source>
        <translation>คลิกเพื่อลบสิ่งนี้</translation>
    </message>
    <message>
        <source>Write on the plan: names, notes, anything</source>
        <translation>เขียนบนแปลน: ชื่อ บันทึก หรืออะไรก็ได้</translation>
    </message>
    <message>
        <source>Click where the text is to stand</source>
        <translation>คลิกตำแหน่งที่จะวางข้อความ</translation>
    </message>
    <message>
        <source>new line</source>
        <translation>ขึ้นบรรทัดใหม่</translation>
    </message>
    <message>
        <source>drop it</source>
        <translation>ทิ้ง</translation>
    </message>
    <message>
        <source>Type the text, then press Enter</source>
        <translation>พิมพ์ข้อความแล้วกด Enter</translation>
    </message>
    <message>
        <source>Texts are written on the plan X-Y</source>
        <translation>ข้อความเขียนบนแปลน X-Y</translation>
    </message>
    <message>
        <source>Add text</source>
        <translation>เพิ่มข้อความ</translation>
    </message>
    <message>
        <source>Doors and windows stand in walls: draw walls first</source>
        <translation>ประตูและหน้าต่างอยู่ในผนัง: เขียนผนังก่อน</translation>
    </message>
    <message>
        <source>No wall has room left for it</source>
        <translation>ไม่มีผนังใดมีที่ว่างพอ</translation>
    </message>
    <message>
        <source>Add door</source>
        <translation>เพิ่มประตู</translation>
    </message>
    <message>
        <source>Add window</source>
        <translation>เพิ่มหน้าต่าง</translation>
    </message>
    <message>
        <source>There is no free place left in this room: move the piece yourself</source>
        <translation>ห้องนี้ไม่มีที่ว่างแล้ว โปรดย้ายเอง</translation>
    </message>
    <message>
        <source>Put a piece of the catalog into the home</source>
        <translation>วางชิ้นจากแค็ตตาล็อกลงในบ้าน</translation>
    </message>
    <message>
        <source>Click where the piece is to stand, or type its distances</source>
        <translation>คลิกตำแหน่งที่จะวาง หรือพิมพ์ระยะ</translation>
    </message>
    <message>
        <source>turn by 90°</source>
        <translation>หมุน 90°</translation>
    </message>
    <message>
        <source>type a distance</source>
        <translation>พิมพ์ระยะ</translation>
    </message>
    <message>
        <source>the next distance</source>
        <translation>ระยะถัดไป</translation>
    </message>
    <message>
        <source>place it</source>
        <translation>วาง</translation>
    </message>
    <message>
        <source>Stands on top</source>
        <translation>วางด้านบน</translation>
    </message>
    <message>
        <source>Add lamp</source>
        <translation>เพิ่มโคมไฟ</translation>
    </message>
    <message>
        <source>Add stairs</source>
        <translation>เพิ่มบันได</translation>
    </message>
    <message>
        <source>Add furniture</source>
        <translation>เพิ่มเฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>The catalog has no piece of this kind</source>
        <translation>แค็ตตาล็อกไม่มีชิ้นชนิดนี้</translation>
    </message>
    <message>
        <source>Move it to a wall</source>
        <translation>ย้ายไปที่ผนัง</translation>
    </message>
    <message>
        <source>Sill height</source>
        <translation>ระดับขอบล่าง</translation>
    </message>
    <message>
        <source>Doors and windows stand in walls: click on or beside one</source>
        <translation>ประตูและหน้าต่างอยู่ในผนัง: คลิกที่ผนังหรือข้างผนัง</translation>
    </message>
    <message>
        <source>the next way it opens</source>
        <translation>ทิศการเปิดถัดไป</translation>
    </message>
    <message>
        <source>the other end, the sill</source>
        <translation>อีกปลาย, ขอบล่าง</translation>
    </message>
    <message>
        <source>Click the wall where it is to be</source>
        <translation>คลิกผนังที่จะวาง</translation>
    </message>
    <message>
        <source>Put doors into walls; other kinds of doors are in the catalog</source>
        <translation>ใส่ประตูในผนัง ประตูแบบอื่นอยู่ในแค็ตตาล็อก</translation>
    </message>
    <message>
        <source>Click the wall where the door is to be, on the side it opens to</source>
        <translation>คลิกผนังที่จะใส่ประตู ทางด้านที่ประตูเปิดออก</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>หน้าต่าง</translation>
    </message>
    <message>
        <source>Put windows into walls; other kinds are in the catalog</source>
        <translation>ใส่หน้าต่างในผนัง แบบอื่นอยู่ในแค็ตตาล็อก</translation>
    </message>
    <message>
        <source>Click the wall where the window is to be</source>
        <translation>คลิกผนังที่จะใส่หน้าต่าง</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>ช่องเปิด</translation>
    </message>
    <message>
        <source>Cut passages into walls, with no door in them</source>
        <translation>เจาะช่องทางเดินในผนังโดยไม่มีบานประตู</translation>
    </message>
    <message>
        <source>Click the wall where the opening is to be</source>
        <translation>คลิกผนังที่จะเจาะช่อง</translation>
    </message>
    <message>
        <source>Add opening</source>
        <translation>เพิ่มช่องเปิด</translation>
    </message>
    <message>
        <source>Polyline</source>
        <translation>โพลีไลน์</translation>
    </message>
    <message>
        <source>Draw lines on the plan: arrows, paths, outlines</source>
        <translation>เขียนเส้นบนแปลน: ลูกศร ทางเดิน เส้นขอบ</translation>
    </message>
    <message>
        <source>Click where the line starts</source>
        <translation>คลิกจุดเริ่มเส้น</translation>
    </message>
    <message>
        <source>type the length</source>
        <translation>พิมพ์ความยาว</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>มุม</translation>
    </message>
    <message>
        <source>place the point, or end</source>
        <translation>วางจุด หรือจบ</translation>
    </message>
    <message>
        <source>take the last point back</source>
        <translation>ถอนจุดล่าสุด</translation>
    </message>
    <message>
        <source>Click the next point; double-click to end, or click the first one to close</source>
        <translation>คลิกจุดถัดไป ดับเบิลคลิกเพื่อจบ หรือคลิกจุดแรกเพื่อปิด</translation>
    </message>
    <message>
        <source>Polylines are drawn on the plan X-Y</source>
        <translation>โพลีไลน์เขียนบนแปลน X-Y</translation>
    </message>
    <message>
        <source>Add polyline</source>
        <translation>เพิ่มโพลีไลน์</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>ห้อง</translation>
    </message>
    <message>
        <source>Draw the floor of a room, or fill the space between walls with one</source>
        <translation>เขียนพื้นห้อง หรือเติมพื้นที่ระหว่างผนังให้เป็นห้อง</translation>
    </message>
    <message>
        <source>Double-click inside walls to fill them, or click the corners of the room</source>
        <translation>ดับเบิลคลิกในวงผนังเพื่อเติมห้อง หรือคลิกมุมของห้องทีละมุม</translation>
    </message>
    <message>
        <source>place the corner, or close</source>
        <translation>วางมุม หรือปิด</translation>
    </message>
    <message>
        <source>take the last corner back</source>
        <translation>ถอนมุมล่าสุด</translation>
    </message>
    <message>
        <source>Click the next corner; on the first one, or double-click, to close</source>
        <translation>คลิกมุมถัดไป คลิกมุมแรกหรือดับเบิลคลิกเพื่อปิด</translation>
    </message>
    <message>
        <source>Rooms are drawn on the plan X-Y</source>
        <translation>ห้องเขียนบนแปลน X-Y</translation>
    </message>
    <message>
        <source>No walls close around this point: draw the room corner by corner</source>
        <translation>ไม่มีผนังล้อมรอบจุดนี้ โปรดเขียนห้องทีละมุม</translation>
    </message>
    <message>
        <source>There is a room already</source>
        <translation>มีห้องอยู่แล้ว</translation>
    </message>
    <message>
        <source>Add room</source>
        <translation>เพิ่มห้อง</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>ระยะ</translation>
    </message>
    <message>
        <source>Drop it into a wall. The side of the pointer is where it opens to. Ctrl copies, Tab chooses a distance to type.</source>
        <translation>ปล่อยลงในผนัง ด้านที่เมาส์อยู่คือด้านที่เปิดออก Ctrl คัดลอก Tab เลือกระยะที่จะพิมพ์</translation>
    </message>
    <message>
        <source>Shift keeps to one axis, Ctrl copies, Alt stops snapping.</source>
        <translation>Shift ตรึงแกนเดียว Ctrl คัดลอก Alt หยุดสแนป</translation>
    </message>
    <message>
        <source>Type a distance and press Enter; Tab chooses which. Shift keeps to one axis, Ctrl copies, Alt stops snapping.</source>
        <translation>พิมพ์ระยะแล้วกด Enter กด Tab เลือกระยะ Shift ตรึงแกนเดียว Ctrl คัดลอก Alt หยุดสแนป</translation>
    </message>
    <message>
        <source>Drag to turn.</source>
        <translation>ลากเพื่อหมุน</translation>
    </message>
    <message>
        <source>Drag to resize; Shift keeps the proportions.</source>
        <translation>ลากเพื่อปรับขนาด Shift คงสัดส่วน</translation>
    </message>
    <message>
        <source>Drag up or down to lift or lower.</source>
        <translation>ลากขึ้นลงเพื่อยกหรือลดระดับ</translation>
    </message>
    <message>
        <source>Drag to tilt.</source>
        <translation>ลากเพื่อเอียง</translation>
    </message>
    <message>
        <source>To the right: selects what lies wholly inside. To the left: also what it touches.</source>
        <translation>ลากไปขวา: เลือกสิ่งที่อยู่ในกรอบทั้งชิ้น ลากไปซ้าย: รวมสิ่งที่แตะกรอบด้วย</translation>
    </message>
    <message>
        <source>Resize</source>
        <translation>ปรับขนาด</translation>
    </message>
    <message>
        <source>Shift keeps the proportions, Alt stops snapping. Or type the size and press Enter.</source>
        <translation>Shift คงสัดส่วน Alt หยุดสแนป หรือพิมพ์ขนาดแล้วกด Enter</translation>
    </message>
    <message>
        <source>Resizes all together. Or type the width of all and press Enter.</source>
        <translation>ปรับขนาดไปพร้อมกัน หรือพิมพ์ความกว้างรวมแล้วกด Enter</translation>
    </message>
    <message>
        <source>Turns in steps of 15°; Alt turns freely. Or type the angle and press Enter.</source>
        <translation>หมุนทีละ 15° กด Alt หมุนอิสระ หรือพิมพ์มุมแล้วกด Enter</translation>
    </message>
    <message>
        <source>Tilts in steps of 15°; Alt tilts freely. Or type the angle and press Enter.</source>
        <translation>เอียงทีละ 15° กด Alt เอียงอิสระ หรือพิมพ์มุมแล้วกด Enter</translation>
    </message>
    <message>
        <source>Drag up or down to lift or lower. Or type the elevation and press Enter.</source>
        <translation>ลากขึ้นลงเพื่อยกหรือลดระดับ หรือพิมพ์ระดับแล้วกด Enter</translation>
    </message>
    <message>
        <source>Draw walls one after the other; where they close, they make a room</source>
        <translation>เขียนผนังต่อเนื่องกัน เมื่อล้อมครบจะเกิดเป็นห้อง</translation>
    </message>
    <message>
        <source>Click where the first wall starts</source>
        <translation>คลิกจุดเริ่มของผนังแรก</translation>
    </message>
    <message>
        <source>angle, thickness, arc</source>
        <translation>มุม, ความหนา, ส่วนโค้ง</translation>
    </message>
    <message>
        <source>place it, or end</source>
        <translation>วาง หรือจบ</translation>
    </message>
    <message>
        <source>round wall</source>
        <translation>ผนังโค้ง</translation>
    </message>
    <message>
        <source>take the last one back</source>
        <translation>ถอนอันล่าสุด</translation>
    </message>
    <message>
        <source>Click where the wall ends, or type its length; double-click or right-click to stop</source>
        <translation>คลิกจุดปลายผนัง หรือพิมพ์ความยาว ดับเบิลคลิกหรือคลิกขวาเพื่อหยุด</translation>
    </message>
    <message>
        <source>Click where the round wall passes, or type its arc</source>
        <translation>คลิกจุดที่ผนังโค้งผ่าน หรือพิมพ์มุมโค้ง</translation>
    </message>
    <message>
        <source>Walls are drawn on the plan X-Y</source>
        <translation>ผนังเขียนบนแปลน X-Y</translation>
    </message>
    <message>
        <source>There is a wall already</source>
        <translation>มีผนังอยู่แล้ว</translation>
    </message>
    <message>
        <source>Add wall</source>
        <translation>เพิ่มผนัง</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>ความหนา</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>ส่วนโค้ง</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>โคมไฟ</translation>
    </message>
    <message>
        <source>Furniture</source>
        <translation>เฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>Stairs</source>
        <translation>บันได</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ใช่</translation>
    </message>
    <message>
        <source>no</source>
        <translation>ไม่ใช่</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>เปลี่ยนชื่อ</translation>
    </message>
    <message>
        <source>In the wall</source>
        <translation>ในผนัง</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>ชนิด</translation>
    </message>
    <message>
        <source>Change kind</source>
        <translation>เปลี่ยนชนิด</translation>
    </message>
    <message>
        <source>How it is counted in lists and drawn on the plan.</source>
        <translation>วิธีนับในรายการและเขียนบนแปลน</translation>
    </message>
    <message>
        <source>Bare opening</source>
        <translation>ช่องเปิดโล่ง</translation>
    </message>
    <message>
        <source>From wall start</source>
        <translation>จากต้นผนัง</translation>
    </message>
    <message>
        <source>Along the middle of the wall, from its start to the opening.</source>
        <translation>วัดตามแนวกลางผนัง จากต้นผนังถึงช่องเปิด</translation>
    </message>
    <message>
        <source>To wall end</source>
        <translation>ถึงปลายผนัง</translation>
    </message>
    <message>
        <source>Along the middle of the wall, from the opening to its end.</source>
        <translation>วัดตามแนวกลางผนัง จากช่องเปิดถึงปลายผนัง</translation>
    </message>
    <message>
        <source>The wall it is in, and follows.</source>
        <translation>ผนังที่อยู่และเคลื่อนตาม</translation>
    </message>
    <message>
        <source>Hinges on the other side</source>
        <translation>สลับข้างบานพับ</translation>
    </message>
    <message>
        <source>Left-handed becomes right-handed.</source>
        <translation>เปิดซ้ายกลายเป็นเปิดขวา</translation>
    </message>
    <message>
        <source>Change hinges</source>
        <translation>เปลี่ยนข้างบานพับ</translation>
    </message>
    <message>
        <source>Opens to the other side</source>
        <translation>เปิดไปอีกด้าน</translation>
    </message>
    <message>
        <source>Turned round in its wall; the hinges stay where they are.</source>
        <translation>พลิกด้านในผนัง บานพับอยู่ที่เดิม</translation>
    </message>
    <message>
        <source>Change direction of opening</source>
        <translation>เปลี่ยนทิศการเปิด</translation>
    </message>
    <message>
        <source>Select its wall</source>
        <translation>เลือกผนังนี้</translation>
    </message>
    <message>
        <source>Shows the properties of the wall it is in.</source>
        <translation>แสดงคุณสมบัติของผนังที่ช่องเปิดอยู่</translation>
    </message>
    <message>
        <source>Change length</source>
        <translation>เปลี่ยนความยาว</translation>
    </message>
    <message>
        <source>Along its middle. Its start stays, its end moves, with the wall joined there.</source>
        <translation>วัดตามแนวกลาง ต้นอยู่ที่เดิม ปลายเลื่อนพร้อมผนังที่ต่ออยู่</translation>
    </message>
    <message>
        <source>Turn wall</source>
        <translation>หมุนผนัง</translation>
    </message>
    <message>
        <source>Of its direction, counter-clockwise from the right. Its start stays.</source>
        <translation>มุมของแนวผนัง ทวนเข็มจากทางขวา ต้นอยู่ที่เดิม</translation>
    </message>
    <message>
        <source>Change thickness</source>
        <translation>เปลี่ยนความหนา</translation>
    </message>
    <message>
        <source>Half of it on either side of the middle.</source>
        <translation>แบ่งครึ่งไปสองข้างของแนวกลาง</translation>
    </message>
    <message>
        <source>Above the floor, from end to end.</source>
        <translation>สูงจากพื้น ตลอดแนว</translation>
    </message>
    <message>
        <source>Height at start</source>
        <translation>ความสูงที่ต้น</translation>
    </message>
    <message>
        <source>For a wall with a sloping top.</source>
        <translation>สำหรับผนังยอดลาดเอียง</translation>
    </message>
    <message>
        <source>Height at end</source>
        <translation>ความสูงที่ปลาย</translation>
    </message>
    <message>
        <source>Bend wall</source>
        <translation>ดัดผนัง</translation>
    </message>
    <message>
        <source>How far a round wall goes round: 0 is straight, 180 half a circle, negative to the other side.</source>
        <translation>มุมโค้งของผนัง: 0 คือตรง 180 คือครึ่งวงกลม ค่าลบโค้งไปอีกด้าน</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>ลวดลาย</translation>
    </message>
    <message>
        <source>Change pattern</source>
        <translation>เปลี่ยนลวดลาย</translation>
    </message>
    <message>
        <source>How it is hatched on the plan.</source>
        <translation>ลายแรเงาบนแปลน</translation>
    </message>
    <message>
        <source>Usual</source>
        <translation>ปกติ</translation>
    </message>
    <message>
        <source>Hatched upwards</source>
        <translation>แรเงาเฉียงขึ้น</translation>
    </message>
    <message>
        <source>Hatched downwards</source>
        <translation>แรเงาเฉียงลง</translation>
    </message>
    <message>
        <source>Cross-hatched</source>
        <translation>แรเงาตาราง</translation>
    </message>
    <message>
        <source>Filled</source>
        <translation>ทึบ</translation>
    </message>
    <message>
        <source>Seen where the wall is lower than the room.</source>
        <translation>เห็นได้เมื่อผนังต่ำกว่าห้อง</translation>
    </message>
    <message>
        <source>White paint</source>
        <translation>สีขาว</translation>
    </message>
    <message>
        <source>Paint, paper or tiles of this side. Left and right are seen from the start of the wall to its end.</source>
        <translation>สี วอลเปเปอร์ หรือกระเบื้องของด้านนี้ ซ้ายขวามองจากต้นผนังไปปลายผนัง</translation>
    </message>
    <message>
        <source>Skirting board</source>
        <translation>บัวพื้น</translation>
    </message>
    <message>
        <source>Change skirting board</source>
        <translation>เปลี่ยนบัวพื้น</translation>
    </message>
    <message>
        <source>A board along the foot of the wall.</source>
        <translation>แผ่นไม้ตามแนวเชิงผนัง</translation>
    </message>
    <message>
        <source>Board height</source>
        <translation>ความสูงบัว</translation>
    </message>
    <message>
        <source>Board thickness</source>
        <translation>ความหนาบัว</translation>
    </message>
    <message>
        <source>Board finish</source>
        <translation>ผิวบัว</translation>
    </message>
    <message>
        <source>As the wall</source>
        <translation>ตามผนัง</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>ปลาย</translation>
    </message>
    <message>
        <source>Start X</source>
        <translation>ต้น X</translation>
    </message>
    <message>
        <source>Move end of wall</source>
        <translation>ย้ายปลายผนัง</translation>
    </message>
    <message>
        <source>Where its middle begins; a wall joined there follows.</source>
        <translation>จุดเริ่มแนวกลาง ผนังที่ต่ออยู่จะตามไป</translation>
    </message>
    <message>
        <source>Start Y</source>
        <translation>ต้น Y</translation>
    </message>
    <message>
        <source>End X</source>
        <translation>ปลาย X</translation>
    </message>
    <message>
        <source>Where its middle ends; a wall joined there follows.</source>
        <translation>จุดสิ้นสุดแนวกลาง ผนังที่ต่ออยู่จะตามไป</translation>
    </message>
    <message>
        <source>End Y</source>
        <translation>ปลาย Y</translation>
    </message>
    <message>
        <source>Aim camera</source>
        <translation>เล็งกล้อง</translation>
    </message>
    <message>
        <source>Change field of view</source>
        <translation>เปลี่ยนมุมรับภาพ</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>มุมรับภาพ</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>มุมหัน</translation>
    </message>
    <message>
        <source>Turns the view in steps of 15°; Alt turns freely. Or type the angle.</source>
        <translation>หันทีละ 15° กด Alt หันอิสระ หรือพิมพ์มุม</translation>
    </message>
    <message>
        <source>How wide the lens sees. Or type the angle.</source>
        <translation>ความกว้างที่เลนส์เห็น หรือพิมพ์มุม</translation>
    </message>
    <message>
        <source>Drag to aim the camera.</source>
        <translation>ลากเพื่อเล็งกล้อง</translation>
    </message>
    <message>
        <source>Drag to widen or narrow the view.</source>
        <translation>ลากเพื่อขยายหรือลดมุมรับภาพ</translation>
    </message>
    <message>
        <source>Snaps to ends, corners and lines; Alt stops snapping.</source>
        <translation>สแนปเข้าหาปลาย มุม และเส้น Alt หยุดสแนป</translation>
    </message>
    <message>
        <source>Type a length, Tab for the angle, Enter to apply; Alt stops snapping.</source>
        <translation>พิมพ์ความยาว กด Tab ใส่มุม กด Enter เพื่อใช้ Alt หยุดสแนป</translation>
    </message>
    <message>
        <source>Move dimension</source>
        <translation>ย้ายเส้นบอกขนาด</translation>
    </message>
    <message>
        <source>How far the line stands off what it measures. Or type it and press Enter.</source>
        <translation>ระยะห่างของเส้นจากสิ่งที่วัด หรือพิมพ์แล้วกด Enter</translation>
    </message>
    <message>
        <source>Drag to move the point; Delete removes it.</source>
        <translation>ลากเพื่อย้ายจุด กด Delete เพื่อลบ</translation>
    </message>
    <message>
        <source>Move point</source>
        <translation>ย้ายจุด</translation>
    </message>
    <message>
        <source>Drag to measure from another point.</source>
        <translation>ลากเพื่อวัดจากจุดอื่น</translation>
    </message>
    <message>
        <source>Drag to move the line away from what it measures.</source>
        <translation>ลากเพื่อเลื่อนเส้นออกจากสิ่งที่วัด</translation>
    </message>
    <message>
        <source>Select things, and move, turn and resize them by their handles</source>
        <translation>เลือกสิ่งต่าง ๆ แล้วย้าย หมุน ปรับขนาดด้วยจุดจับ</translation>
    </message>
    <message>
        <source>Click to select, drag to move. Drag over an empty place to select all in a rectangle.</source>
        <translation>คลิกเพื่อเลือก ลากเพื่อย้าย ลากบนที่ว่างเพื่อเลือกทั้งกรอบ</translation>
    </message>
    <message>
        <source>add to the selection; keep to one axis or the proportions</source>
        <translation>เพิ่มในสิ่งที่เลือก; ตรึงแกนเดียวหรือคงสัดส่วน</translation>
    </message>
    <message>
        <source>take out or add; copy while dragging</source>
        <translation>เอาออกหรือเพิ่ม; คัดลอกขณะลาก</translation>
    </message>
    <message>
        <source>the next value to type while dragging</source>
        <translation>ค่าถัดไปที่จะพิมพ์ขณะลาก</translation>
    </message>
    <message>
        <source>move by 1 cm; Shift 10 cm, Alt 1 mm</source>
        <translation>ย้าย 1 ซม. Shift 10 ซม. Alt 1 มม.</translation>
    </message>
    <message>
        <source>lift, lower</source>
        <translation>ยก, ลดระดับ</translation>
    </message>
    <message>
        <source>delete; over the point of a room or line only that</source>
        <translation>ลบ; ถ้าเมาส์อยู่บนจุดของห้องหรือเส้น ลบเฉพาะจุดนั้น</translation>
    </message>
    <message>
        <source>take back the drag; select nothing</source>
        <translation>ยกเลิกการลาก; ไม่เลือกอะไร</translation>
    </message>
    <message>
        <source>Drag to move, with Ctrl to copy. Click again for what lies under it.</source>
        <translation>ลากเพื่อย้าย กด Ctrl เพื่อคัดลอก คลิกซ้ำเพื่อเลือกสิ่งที่อยู่ใต้</translation>
    </message>
    <message>
        <source>What is locked does not move. Unlock it first.</source>
        <translation>สิ่งที่ล็อกจะไม่ขยับ ปลดล็อกก่อน</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>เพิ่มจุด</translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation>ลบจุด</translation>
    </message>
    <message>
        <source>Move corner</source>
        <translation>ย้ายมุม</translation>
    </message>
    <message>
        <source>Walls that meet here follow. Type a length, Tab for the angle, Enter to apply; Alt stops snapping.</source>
        <translation>ผนังที่บรรจบตรงนี้จะตามไป พิมพ์ความยาว กด Tab ใส่มุม กด Enter เพื่อใช้ Alt หยุดสแนป</translation>
    </message>
    <message>
        <source>Bends the wall; back on its line it is straight. Or type the angle of the arc.</source>
        <translation>ดัดผนังให้โค้ง กลับมาที่แนวเดิมจะตรง หรือพิมพ์มุมโค้ง</translation>
    </message>
    <message>
        <source>The wall&apos;s height at this end; with Shift at both. Or type it and press Enter.</source>
        <translation>ความสูงผนังที่ปลายนี้ กด Shift ปรับทั้งสองปลาย หรือพิมพ์แล้วกด Enter</translation>
    </message>
    <message>
        <source>Drag to move the corner with all walls that meet there.</source>
        <translation>ลากเพื่อย้ายมุมพร้อมผนังทุกแนวที่บรรจบกัน</translation>
    </message>
    <message>
        <source>Drag to bend the wall.</source>
        <translation>ลากเพื่อดัดผนัง</translation>
    </message>
    <message>
        <source>Drag to change the height; with Shift at both ends.</source>
        <translation>ลากเพื่อเปลี่ยนความสูง กด Shift ปรับทั้งสองปลาย</translation>
    </message>
    <message>
        <source>Duplicate point of view</source>
        <translation>ทำสำเนามุมกล้อง</translation>
    </message>
    <message>
        <source>Delete point of view</source>
        <translation>ลบมุมกล้อง</translation>
    </message>
    <message>
        <source>Order points of view</source>
        <translation>เรียงลำดับมุมกล้อง</translation>
    </message>
    <message>
        <source>Untitled home</source>
        <translation>บ้านไม่มีชื่อ</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>แปลน</translation>
    </message>
    <message>
        <source>Front elevation</source>
        <translation>รูปด้านหน้า</translation>
    </message>
    <message>
        <source>Side elevation</source>
        <translation>รูปด้านข้าง</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>มาตราส่วน</translation>
    </message>
    <message>
        <source>Point of view</source>
        <translation>มุมกล้อง</translation>
    </message>
    <message>
        <source>How it is called in the list of points of view.</source>
        <translation>ชื่อในรายการมุมกล้อง</translation>
    </message>
    <message>
        <source>Change eye height</source>
        <translation>เปลี่ยนระดับตา</translation>
    </message>
    <message>
        <source>Above the floor of the level drawn: 1.6 m standing, 1.2 m sitting.</source>
        <translation>เหนือพื้นของชั้นที่เขียนอยู่: ยืน 1.6 ม. นั่ง 1.2 ม.</translation>
    </message>
    <message>
        <source>Its eye, to the right of the origin.</source>
        <translation>ตำแหน่งตา วัดไปทางขวาจากจุดกำเนิด</translation>
    </message>
    <message>
        <source>Its eye, up the plan from the origin.</source>
        <translation>ตำแหน่งตา วัดขึ้นไปบนแปลนจากจุดกำเนิด</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>ทิศทาง</translation>
    </message>
    <message>
        <source>Counter-clockwise from looking up the plan.</source>
        <translation>ทวนเข็มนาฬิกาจากการมองขึ้นไปบนแปลน</translation>
    </message>
    <message>
        <source>Looks down</source>
        <translation>มุมก้ม</translation>
    </message>
    <message>
        <source>0 looks level, 90 straight down, negative up.</source>
        <translation>0 มองตรง 90 มองลงตรง ๆ ค่าลบมองขึ้น</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>เลนส์</translation>
    </message>
    <message>
        <source>Change lens</source>
        <translation>เปลี่ยนเลนส์</translation>
    </message>
    <message>
        <source>Parallel keeps sizes, as plans do; fisheye and panorama see all around.</source>
        <translation>แบบขนานคงขนาดเหมือนแปลน ฟิชอายและพาโนรามาเห็นรอบทิศ</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>ขนาน</translation>
    </message>
    <message>
        <source>Fisheye</source>
        <translation>ฟิชอาย</translation>
    </message>
    <message>
        <source>Panorama</source>
        <translation>พาโนรามา</translation>
    </message>
    <message>
        <source>From the left edge of the picture to the right: 60 to 75 suits rooms.</source>
        <translation>จากขอบซ้ายถึงขอบขวาของภาพ: 60 ถึง 75 เหมาะกับห้อง</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>ความยาวโฟกัส</translation>
    </message>
    <message>
        <source>Change focal length</source>
        <translation>เปลี่ยนความยาวโฟกัส</translation>
    </message>
    <message>
        <source>The same as on a 35 mm camera: 24 wide, 35 usual for rooms, 50 normal.</source>
        <translation>เทียบกล้อง 35 มม.: 24 มุมกว้าง 35 มักใช้กับห้อง 50 ปกติ</translation>
    </message>
    <message>
        <source>A time of its own</source>
        <translation>ใช้เวลาของตัวเอง</translation>
    </message>
    <message>
        <source>Change time</source>
        <translation>เปลี่ยนเวลา</translation>
    </message>
    <message>
        <source>Otherwise its pictures are of the home&apos;s time.</source>
        <translation>ถ้าไม่ใช้ ภาพจะใช้เวลาของบ้าน</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>เวลา</translation>
    </message>
    <message>
        <source>The moment of its pictures: it sets the sun.</source>
        <translation>เวลาของภาพ: กำหนดตำแหน่งดวงอาทิตย์</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>สิ่งที่เลือก</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>ชั้น</translation>
    </message>
    <message>
        <source>Puts all that is selected on another level, at the same height above its floor.</source>
        <translation>ย้ายสิ่งที่เลือกทั้งหมดไปชั้นอื่น ที่ความสูงเหนือพื้นเท่าเดิม</translation>
    </message>
    <message>
        <source>Of the pieces among them.</source>
        <translation>ของชิ้นที่อยู่ในนั้น</translation>
    </message>
    <message>
        <source>Delete all of it</source>
        <translation>ลบทั้งหมดนี้</translation>
    </message>
    <message>
        <source>Takes all that is selected out of the home. Undo brings it back.</source>
        <translation>ลบสิ่งที่เลือกทั้งหมดออกจากบ้าน เลิกทำเพื่อเอากลับมาได้</translation>
    </message>
    <message>
        <source>Hides or shows all of it.</source>
        <translation>ซ่อนหรือแสดงทั้งหมด</translation>
    </message>
    <message>
        <source>The middle of the whole, to the right of the origin.</source>
        <translation>จุดกึ่งกลางทั้งหมด วัดไปทางขวาจากจุดกำเนิด</translation>
    </message>
    <message>
        <source>The middle of the whole, up the plan from the origin.</source>
        <translation>จุดกึ่งกลางทั้งหมด วัดขึ้นไปบนแปลนจากจุดกำเนิด</translation>
    </message>
    <message>
        <source>Its lowest point above the floor of the level drawn.</source>
        <translation>จุดต่ำสุดเหนือพื้นของชั้นที่เขียนอยู่</translation>
    </message>
    <message>
        <source>Of the whole; all its pieces change in proportion.</source>
        <translation>ของทั้งหมด ทุกชิ้นเปลี่ยนตามสัดส่วน</translation>
    </message>
    <message>
        <source>Its pieces stay where they are, each on its own.</source>
        <translation>แต่ละชิ้นอยู่ที่เดิมและแยกจากกัน</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>บ้าน</translation>
    </message>
    <message>
        <source>What the home is called in lists of files.</source>
        <translation>ชื่อบ้านในรายการไฟล์</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>ชื่อเรื่อง</translation>
    </message>
    <message>
        <source>Change title</source>
        <translation>เปลี่ยนชื่อเรื่อง</translation>
    </message>
    <message>
        <source>Stands on prints.</source>
        <translation>แสดงบนงานพิมพ์</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>บันทึก</translation>
    </message>
    <message>
        <source>Change notes</source>
        <translation>เปลี่ยนบันทึก</translation>
    </message>
    <message>
        <source>Anything to remember. Control+Enter or leaving the field applies.</source>
        <translation>สิ่งที่ควรจำ กด Control+Enter หรือออกจากช่องเพื่อใช้</translation>
    </message>
    <message>
        <source>Wall height</source>
        <translation>ความสูงผนัง</translation>
    </message>
    <message>
        <source>Change wall height</source>
        <translation>เปลี่ยนความสูงผนัง</translation>
    </message>
    <message>
        <source>Of walls that are drawn from now on.</source>
        <translation>ของผนังที่เขียนต่อจากนี้</translation>
    </message>
    <message>
        <source>Currency</source>
        <translation>สกุลเงิน</translation>
    </message>
    <message>
        <source>Change currency</source>
        <translation>เปลี่ยนสกุลเงิน</translation>
    </message>
    <message>
        <source>Of all prices: EUR, USD, THB.</source>
        <translation>ของทุกราคา: EUR, USD, THB</translation>
    </message>
    <message>
        <source>Total price</source>
        <translation>ราคารวม</translation>
    </message>
    <message>
        <source>Of all furniture, doors and windows that have a price.</source>
        <translation>ของเฟอร์นิเจอร์ ประตู และหน้าต่างทั้งหมดที่มีราคา</translation>
    </message>
    <message>
        <source>Floor area</source>
        <translation>พื้นที่ใช้สอย</translation>
    </message>
    <message>
        <source>Of all rooms on all levels.</source>
        <translation>ของทุกห้องทุกชั้น</translation>
    </message>
    <message>
        <source>Change elevation</source>
        <translation>เปลี่ยนระดับ</translation>
    </message>
    <message>
        <source>Of the top of its floor.</source>
        <translation>ของผิวบนของพื้น</translation>
    </message>
    <message>
        <source>From its floor to its ceiling.</source>
        <translation>จากพื้นถึงเพดาน</translation>
    </message>
    <message>
        <source>Floor thickness</source>
        <translation>ความหนาพื้น</translation>
    </message>
    <message>
        <source>Change floor thickness</source>
        <translation>เปลี่ยนความหนาพื้น</translation>
    </message>
    <message>
        <source>Of the slab below it.</source>
        <translation>ของแผ่นพื้นด้านล่าง</translation>
    </message>
    <message>
        <source>Whether all that is on it shows in pictures.</source>
        <translation>ให้ทุกอย่างบนชั้นนี้ปรากฏในภาพหรือไม่</translation>
    </message>
    <message>
        <source>Place and time</source>
        <translation>สถานที่และเวลา</translation>
    </message>
    <message>
        <source>The moment of pictures: it sets the sun.</source>
        <translation>เวลาของภาพ: กำหนดตำแหน่งดวงอาทิตย์</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>ดวงอาทิตย์</translation>
    </message>
    <message>
        <source>Where it stands at that time.</source>
        <translation>ตำแหน่งดวงอาทิตย์ ณ เวลานั้น</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>ละติจูด</translation>
    </message>
    <message>
        <source>Change place</source>
        <translation>เปลี่ยนสถานที่</translation>
    </message>
    <message>
        <source>North of the equator in degrees; south is negative.</source>
        <translation>องศาเหนือเส้นศูนย์สูตร ทิศใต้เป็นค่าลบ</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>ลองจิจูด</translation>
    </message>
    <message>
        <source>East of Greenwich in degrees; west is negative.</source>
        <translation>องศาตะวันออกของกรีนิช ทิศตะวันตกเป็นค่าลบ</translation>
    </message>
    <message>
        <source>Time zone</source>
        <translation>เขตเวลา</translation>
    </message>
    <message>
        <source>Change time zone</source>
        <translation>เปลี่ยนเขตเวลา</translation>
    </message>
    <message>
        <source>By its international name: Europe/Paris, Asia/Bangkok.</source>
        <translation>ตามชื่อสากล: Europe/Paris, Asia/Bangkok</translation>
    </message>
    <message>
        <source>There is no time zone “%1”. Write it like Europe/Paris.</source>
        <translation>ไม่มีเขตเวลา “%1” พิมพ์แบบ Asia/Bangkok</translation>
    </message>
    <message>
        <source>North</source>
        <translation>ทิศเหนือ</translation>
    </message>
    <message>
        <source>Turn north</source>
        <translation>หมุนทิศเหนือ</translation>
    </message>
    <message>
        <source>Counter-clockwise from the top of the plan.</source>
        <translation>ทวนเข็มนาฬิกาจากด้านบนของแปลน</translation>
    </message>
    <message>
        <source>Compass on the plan</source>
        <translation>เข็มทิศบนแปลน</translation>
    </message>
    <message>
        <source>Show compass</source>
        <translation>แสดงเข็มทิศ</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>พื้นดิน</translation>
    </message>
    <message>
        <source>Change ground</source>
        <translation>เปลี่ยนพื้นดิน</translation>
    </message>
    <message>
        <source>What the home stands on, in pictures from outside.</source>
        <translation>สิ่งที่บ้านตั้งอยู่ เห็นในภาพจากภายนอก</translation>
    </message>
    <message>
        <source>Bare</source>
        <translation>เปล่า</translation>
    </message>
    <message>
        <source>1 piece of furniture</source>
        <translation>เฟอร์นิเจอร์ 1 ชิ้น</translation>
    </message>
    <message>
        <source>%1 pieces of furniture</source>
        <translation>เฟอร์นิเจอร์ %1 ชิ้น</translation>
    </message>
    <message>
        <source>1 group</source>
        <translation>1 กลุ่ม</translation>
    </message>
    <message>
        <source>%1 groups</source>
        <translation>%1 กลุ่ม</translation>
    </message>
    <message>
        <source>1 door</source>
        <translation>ประตู 1 บาน</translation>
    </message>
    <message>
        <source>%1 doors</source>
        <translation>ประตู %1 บาน</translation>
    </message>
    <message>
        <source>1 window</source>
        <translation>หน้าต่าง 1 บาน</translation>
    </message>
    <message>
        <source>%1 windows</source>
        <translation>หน้าต่าง %1 บาน</translation>
    </message>
    <message>
        <source>1 opening</source>
        <translation>ช่องเปิด 1 ช่อง</translation>
    </message>
    <message>
        <source>%1 openings</source>
        <translation>ช่องเปิด %1 ช่อง</translation>
    </message>
    <message>
        <source>1 wall</source>
        <translation>ผนัง 1 แนว</translation>
    </message>
    <message>
        <source>%1 walls</source>
        <translation>ผนัง %1 แนว</translation>
    </message>
    <message>
        <source>1 room</source>
        <translation>1 ห้อง</translation>
    </message>
    <message>
        <source>%1 rooms</source>
        <translation>%1 ห้อง</translation>
    </message>
    <message>
        <source>1 point of view</source>
        <translation>1 มุมกล้อง</translation>
    </message>
    <message>
        <source>%1 points of view</source>
        <translation>%1 มุมกล้อง</translation>
    </message>
    <message>
        <source>1 dimension</source>
        <translation>เส้นบอกขนาด 1 เส้น</translation>
    </message>
    <message>
        <source>%1 dimensions</source>
        <translation>เส้นบอกขนาด %1 เส้น</translation>
    </message>
    <message>
        <source>1 text</source>
        <translation>1 ข้อความ</translation>
    </message>
    <message>
        <source>%1 texts</source>
        <translation>%1 ข้อความ</translation>
    </message>
    <message>
        <source>1 line</source>
        <translation>1 เส้น</translation>
    </message>
    <message>
        <source>%1 lines</source>
        <translation>%1 เส้น</translation>
    </message>
    <message>
        <source>Piece of furniture</source>
        <translation>เฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>เส้น</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>%1 รายการ</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>ขนาดตัวอักษร</translation>
    </message>
    <message>
        <source>Change text size</source>
        <translation>เปลี่ยนขนาดตัวอักษร</translation>
    </message>
    <message>
        <source>Height of a line, measured on the plan.</source>
        <translation>ความสูงของบรรทัด วัดบนแปลน</translation>
    </message>
    <message>
        <source>Bold</source>
        <translation>ตัวหนา</translation>
    </message>
    <message>
        <source>Change text style</source>
        <translation>เปลี่ยนลักษณะตัวอักษร</translation>
    </message>
    <message>
        <source>Italic</source>
        <translation>ตัวเอียง</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>การจัดบรรทัด</translation>
    </message>
    <message>
        <source>Of its lines, about its place.</source>
        <translation>ของบรรทัด เทียบกับตำแหน่ง</translation>
    </message>
    <message>
        <source>Centred</source>
        <translation>กึ่งกลาง</translation>
    </message>
    <message>
        <source>Text colour</source>
        <translation>สีตัวอักษร</translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>เปลี่ยนสี</translation>
    </message>
    <message>
        <source>As the plan</source>
        <translation>ตามแปลน</translation>
    </message>
    <message>
        <source>Stands in the room on the plan.</source>
        <translation>แสดงในห้องบนแปลน</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>พื้นที่</translation>
    </message>
    <message>
        <source>Of its floor; of several rooms together.</source>
        <translation>ของพื้น ถ้าหลายห้องคือรวมกัน</translation>
    </message>
    <message>
        <source>Area on the plan</source>
        <translation>พื้นที่บนแปลน</translation>
    </message>
    <message>
        <source>Show area</source>
        <translation>แสดงพื้นที่</translation>
    </message>
    <message>
        <source>Has a floor</source>
        <translation>มีพื้น</translation>
    </message>
    <message>
        <source>Change floor</source>
        <translation>เปลี่ยนพื้น</translation>
    </message>
    <message>
        <source>Without, one sees down to the level below.</source>
        <translation>ถ้าไม่มี จะมองลงไปเห็นชั้นล่าง</translation>
    </message>
    <message>
        <source>Boards, tiles or carpet.</source>
        <translation>ไม้ กระเบื้อง หรือพรม</translation>
    </message>
    <message>
        <source>Plain floor</source>
        <translation>พื้นเรียบ</translation>
    </message>
    <message>
        <source>Has a ceiling</source>
        <translation>มีเพดาน</translation>
    </message>
    <message>
        <source>Change ceiling</source>
        <translation>เปลี่ยนเพดาน</translation>
    </message>
    <message>
        <source>Without, it is open to above.</source>
        <translation>ถ้าไม่มี จะเปิดโล่งด้านบน</translation>
    </message>
    <message>
        <source>Ceiling</source>
        <translation>เพดาน</translation>
    </message>
    <message>
        <source>Flat ceiling</source>
        <translation>เพดานเรียบ</translation>
    </message>
    <message>
        <source>Level at the height of the storey, even where walls slope.</source>
        <translation>เรียบที่ความสูงของชั้น แม้ผนังจะลาดเอียง</translation>
    </message>
    <message>
        <source>What it measures.</source>
        <translation>ระยะที่วัดได้</translation>
    </message>
    <message>
        <source>Move dimension line</source>
        <translation>ย้ายเส้นบอกขนาด</translation>
    </message>
    <message>
        <source>From what is measured to the line; negative on the other side.</source>
        <translation>จากสิ่งที่วัดถึงเส้น ค่าลบคืออีกด้าน</translation>
    </message>
    <message>
        <source>Height of its figures, measured on the plan.</source>
        <translation>ความสูงของตัวเลข วัดบนแปลน</translation>
    </message>
    <message>
        <source>Change text</source>
        <translation>เปลี่ยนข้อความ</translation>
    </message>
    <message>
        <source>As many lines as you like. Control+Enter or leaving the field applies.</source>
        <translation>กี่บรรทัดก็ได้ กด Control+Enter หรือออกจากช่องเพื่อใช้</translation>
    </message>
    <message>
        <source>Counter-clockwise, in degrees.</source>
        <translation>ทวนเข็มนาฬิกา เป็นองศา</translation>
    </message>
    <message>
        <source>In pictures too</source>
        <translation>แสดงในภาพด้วย</translation>
    </message>
    <message>
        <source>Show text in pictures</source>
        <translation>แสดงข้อความในภาพ</translation>
    </message>
    <message>
        <source>The text stands or lies in the room itself, as a sign does.</source>
        <translation>ข้อความตั้งหรือวางอยู่ในห้องจริงเหมือนป้าย</translation>
    </message>
    <message>
        <source>0 lies flat, 90 stands upright.</source>
        <translation>0 วางราบ 90 ตั้งตรง</translation>
    </message>
    <message>
        <source>Above the floor.</source>
        <translation>เหนือพื้น</translation>
    </message>
    <message>
        <source>Measured on the plan.</source>
        <translation>วัดบนแปลน</translation>
    </message>
    <message>
        <source>Dashes</source>
        <translation>เส้นประ</translation>
    </message>
    <message>
        <source>Change dashes</source>
        <translation>เปลี่ยนเส้นประ</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>ทึบ</translation>
    </message>
    <message>
        <source>Dots</source>
        <translation>จุด</translation>
    </message>
    <message>
        <source>Dash, dot</source>
        <translation>ขีด จุด</translation>
    </message>
    <message>
        <source>Dash, two dots</source>
        <translation>ขีด สองจุด</translation>
    </message>
    <message>
        <source>None</source>
        <translation>ไม่มี</translation>
    </message>
    <message>
        <source>Filled arrow</source>
        <translation>ลูกศรทึบ</translation>
    </message>
    <message>
        <source>Open arrow</source>
        <translation>ลูกศรโปร่ง</translation>
    </message>
    <message>
        <source>Dot</source>
        <translation>จุด</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>ต้น</translation>
    </message>
    <message>
        <source>Change arrow</source>
        <translation>เปลี่ยนหัวลูกศร</translation>
    </message>
    <message>
        <source>End</source>
        <translation>ปลาย</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>เส้นปิด</translation>
    </message>
    <message>
        <source>Close line</source>
        <translation>ปิดเส้น</translation>
    </message>
    <message>
        <source>Its end is joined to its start.</source>
        <translation>ปลายต่อกับต้น</translation>
    </message>
    <message>
        <source>Curved</source>
        <translation>โค้ง</translation>
    </message>
    <message>
        <source>Curve line</source>
        <translation>ทำเส้นโค้ง</translation>
    </message>
    <message>
        <source>A smooth line through its points.</source>
        <translation>เส้นโค้งเรียบผ่านจุดต่าง ๆ</translation>
    </message>
    <message>
        <source>Empty</source>
        <translation>ว่าง</translation>
    </message>
    <message>
        <source>Hatched upwards, dark</source>
        <translation>แรเงาเฉียงขึ้น เข้ม</translation>
    </message>
    <message>
        <source>Hatched downwards, dark</source>
        <translation>แรเงาเฉียงลง เข้ม</translation>
    </message>
    <message>
        <source>Cross-hatched, dark</source>
        <translation>แรเงาตาราง เข้ม</translation>
    </message>
    <message>
        <source>Printed the plan into %1</source>
        <translation>พิมพ์แปลนลง %1 แล้ว</translation>
    </message>
    <message>
        <source>%1 is part of the catalog now</source>
        <translation>เพิ่ม %1 ลงในแค็ตตาล็อกแล้ว</translation>
    </message>
    <message>
        <source>Import a piece</source>
        <translation>นำเข้าชิ้นส่วน</translation>
    </message>
    <message>
        <source>This level has no background picture</source>
        <translation>ชั้นนี้ไม่มีภาพพื้นหลัง</translation>
    </message>
    <message>
        <source>Double-click makes this a room</source>
        <translation>ดับเบิลคลิกเพื่อสร้างเป็นห้อง</translation>
    </message>
    <message>
        <source>Mirror glass</source>
        <translation>กระจกเงา</translation>
    </message>
    <message>
        <source>%1 is not a home; begin a room first, then drop it there</source>
        <translation>%1 ไม่ใช่ไฟล์บ้าน เริ่มห้องก่อน แล้วลากมาวางในห้อง</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>ป้ายข้อความ</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>ชี้</translation>
    </message>
    <message>
        <source>Change the date</source>
        <translation>เปลี่ยนวันที่</translation>
    </message>
    <message>
        <source>Change the weather</source>
        <translation>เปลี่ยนสภาพอากาศ</translation>
    </message>
    <message>
        <source>Switch a lamp</source>
        <translation>เปิดปิดโคมไฟ</translation>
    </message>
    <message>
        <source>Dim a lamp</source>
        <translation>หรี่โคมไฟ</translation>
    </message>
    <message>
        <source>Switch all lamps on</source>
        <translation>เปิดโคมไฟทั้งหมด</translation>
    </message>
    <message>
        <source>Switch all lamps off</source>
        <translation>ปิดโคมไฟทั้งหมด</translation>
    </message>
    <message>
        <source>The live view could not be made: %1</source>
        <translation>สร้างมุมมองสดไม่ได้: %1</translation>
    </message>
    <message>
        <source>Change the time</source>
        <translation>เปลี่ยนเวลา</translation>
    </message>
    <message>
        <source>Keep the point of view</source>
        <translation>เก็บมุมมอง</translation>
    </message>
    <message>
        <source>The point of view is kept as %1</source>
        <translation>เก็บมุมมองไว้เป็น %1</translation>
    </message>
    <message>
        <source>Moves what is held</source>
        <translation>ย้ายสิ่งที่จับอยู่</translation>
    </message>
    <message>
        <source>Let it go where it shall be; Escape takes it back</source>
        <translation>ปล่อยตรงที่ต้องการ กด Escape เพื่อย้อนกลับ</translation>
    </message>
    <message>
        <source>Select a wall, a room or a piece first, or drag the finish onto it</source>
        <translation>เลือกผนัง ห้อง หรือเฟอร์นิเจอร์ก่อน หรือลากวัสดุไปวางบนสิ่งนั้น</translation>
    </message>
    <message>
        <source>The film could not be made: %1</source>
        <translation>สร้างภาพยนตร์ไม่ได้: %1</translation>
    </message>
    <message>
        <source>Film saved as %1</source>
        <translation>บันทึกภาพยนตร์เป็น %1 แล้ว</translation>
    </message>
    <message>
        <source>As in 1993</source>
        <translation>แบบปี 1993</translation>
    </message>
    <message>
        <source>Photograph 10 x 15 cm</source>
        <translation>ภาพถ่าย 10 x 15 ซม.</translation>
    </message>
    <message>
        <source>Photograph 13 x 18 cm</source>
        <translation>ภาพถ่าย 13 x 18 ซม.</translation>
    </message>
    <message>
        <source>A4, 150 dots an inch</source>
        <translation>A4, 150 จุดต่อนิ้ว</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>อิสระ</translation>
    </message>
    <message>
        <source>Delete picture</source>
        <translation>ลบภาพ</translation>
    </message>
    <message>
        <source>Width × depth × height</source>
        <translation>กว้าง × ลึก × สูง</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>จำนวน</translation>
    </message>
    <message>
        <source>Sum</source>
        <translation>รวม</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>รวมทั้งหมด</translation>
    </message>
    <message>
        <source>Walls of rooms</source>
        <translation>ผนังของห้อง</translation>
    </message>
    <message>
        <source>Furniture list</source>
        <translation>รายการเฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>แผ่นที่ %1 จาก %2</translation>
    </message>
    <message>
        <source>%1: wall %2</source>
        <translation>%1: ผนัง %2</translation>
    </message>
    <message>
        <source>%1: walls</source>
        <translation>%1: ผนัง</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>พารามิเตอร์</translation>
    </message>
    <message>
        <source>Change parameters</source>
        <translation>เปลี่ยนพารามิเตอร์</translation>
    </message>
    <message>
        <source>Pict&amp;ures and gallery…</source>
        <translation>ภาพและแกลเลอรี(&amp;U)…</translation>
    </message>
    <message>
        <source>Makes pictures of any size, one or many at once, and keeps them in the home</source>
        <translation>สร้างภาพทุกขนาด ทีละภาพหรือหลายภาพพร้อมกัน และเก็บไว้ในบ้าน</translation>
    </message>
    <message>
        <source>Fil&amp;m…</source>
        <translation>ภาพยนตร์(&amp;M)…</translation>
    </message>
    <message>
        <source>A walk through the home, or a day of sunlight, as a film (MP4)</source>
        <translation>การเดินชมบ้านหรือแสงแดดตลอดวันเป็นภาพยนตร์ (MP4)</translation>
    </message>
    <message>
        <source>&amp;Solids</source>
        <translation>รูปทรงตัน(&amp;S)</translation>
    </message>
    <message>
        <source>type a side</source>
        <translation>พิมพ์ความยาวด้าน</translation>
    </message>
    <message>
        <source>the next side</source>
        <translation>ด้านถัดไป</translation>
    </message>
    <message>
        <source>take it</source>
        <translation>ใช้ค่านี้</translation>
    </message>
    <message>
        <source>equal sides</source>
        <translation>ด้านเท่ากัน</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>กล่อง</translation>
    </message>
    <message>
        <source>Draw boxes in any plane: pillars, steps, built-in furniture</source>
        <translation>วาดกล่องในระนาบใดก็ได้: เสา ขั้นบันได เฟอร์นิเจอร์บิวท์อิน</translation>
    </message>
    <message>
        <source>Press at one corner and drag to the opposite one, in any plane</source>
        <translation>กดที่มุมหนึ่งแล้วลากไปมุมตรงข้าม ในระนาบใดก็ได้</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>ทรงกระบอก</translation>
    </message>
    <message>
        <source>Draw cylinders and cones; their round is seen in the plane they are drawn in</source>
        <translation>วาดทรงกระบอกและกรวย เห็นวงกลมในระนาบที่วาด</translation>
    </message>
    <message>
        <source>Press at one corner of the round and drag to the opposite one, in any plane</source>
        <translation>กดที่มุมหนึ่งของวงกลมแล้วลากไปมุมตรงข้าม ในระนาบใดก็ได้</translation>
    </message>
    <message>
        <source>Click the opposite corner, or type the sides</source>
        <translation>คลิกมุมตรงข้าม หรือพิมพ์ความยาวด้าน</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>รูปร่าง</translation>
    </message>
    <message>
        <source>Draw an outline in any plane and give it a thickness: worktops, gables, steps</source>
        <translation>วาดรูปร่างในระนาบใดก็ได้แล้วให้ความหนา: ท็อปครัว หน้าจั่ว ขั้นบันได</translation>
    </message>
    <message>
        <source>Click the first corner of the outline, in any plane</source>
        <translation>คลิกมุมแรกของรูปร่าง ในระนาบใดก็ได้</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>งานกลึง</translation>
    </message>
    <message>
        <source>Draw half a profile and turn it about its axis: vases, bowls, columns</source>
        <translation>วาดครึ่งหนึ่งของรูปตัดแล้วหมุนรอบแกน: แจกัน ชาม เสา</translation>
    </message>
    <message>
        <source>Click where the axis stands and the profile begins, in any plane</source>
        <translation>คลิกที่ตั้งแกนและจุดเริ่มของรูปตัด ในระนาบใดก็ได้</translation>
    </message>
    <message>
        <source>Click the next corner; click the first one, double-click or Enter to close</source>
        <translation>คลิกมุมถัดไป คลิกมุมแรก ดับเบิลคลิก หรือกด Enter เพื่อปิดรูป</translation>
    </message>
    <message>
        <source>This outline holds no area: draw at least three corners apart</source>
        <translation>รูปร่างนี้ไม่มีพื้นที่: วาดอย่างน้อยสามมุมที่แยกกัน</translation>
    </message>
    <message>
        <source>Click the next point of the profile; double-click or Enter to end</source>
        <translation>คลิกจุดถัดไปของรูปตัด ดับเบิลคลิกหรือกด Enter เพื่อจบ</translation>
    </message>
    <message>
        <source>This profile has no width or no height: draw it beside the axis</source>
        <translation>รูปตัดนี้ไม่มีความกว้างหรือความสูง: วาดไว้ข้างแกน</translation>
    </message>
    <message>
        <source>Add solid</source>
        <translation>เพิ่มรูปทรงตัน</translation>
    </message>
    <message>
        <source>Type how far it goes across, or show it in another plane; click or Enter ends</source>
        <translation>พิมพ์ระยะตามขวาง หรือแสดงในระนาบอื่น คลิกหรือกด Enter เพื่อจบ</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>ทรงกลม</translation>
    </message>
    <message>
        <source>Draw balls; in the plan they lie on the floor</source>
        <translation>วาดทรงกลม ในแปลนจะวางบนพื้น</translation>
    </message>
    <message>
        <source>Press at the centre and drag to the border, in any plane</source>
        <translation>กดที่จุดศูนย์กลางแล้วลากไปที่ขอบ ในระนาบใดก็ได้</translation>
    </message>
    <message>
        <source>type the radius</source>
        <translation>พิมพ์รัศมี</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>รัศมี</translation>
    </message>
    <message>
        <source>Click on the border, or type the radius</source>
        <translation>คลิกที่ขอบ หรือพิมพ์รัศมี</translation>
    </message>
    <message>
        <source>Height of the apron</source>
        <translation>ความสูงของพนักใต้ท็อป</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>แกน</translation>
    </message>
    <message>
        <source>Depth of the bar</source>
        <translation>ความลึกของบาร์</translation>
    </message>
    <message>
        <source>Thickness of the boards</source>
        <translation>ความหนาของแผ่นไม้</translation>
    </message>
    <message>
        <source>Drawers on both sides</source>
        <translation>ลิ้นชักทั้งสองด้าน</translation>
    </message>
    <message>
        <source>Brackets</source>
        <translation>ฉากรับ</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>กระดุม</translation>
    </message>
    <message>
        <source>Channels in the back</source>
        <translation>ร่องที่พนัก</translation>
    </message>
    <message>
        <source>Curtains</source>
        <translation>ผ้าม่าน</translation>
    </message>
    <message>
        <source>Drops of glass</source>
        <translation>หยดแก้ว</translation>
    </message>
    <message>
        <source>Edge of the top</source>
        <translation>ขอบท็อป</translation>
    </message>
    <message>
        <source>Width of the frame</source>
        <translation>ความกว้างของกรอบ</translation>
    </message>
    <message>
        <source>Fronts</source>
        <translation>หน้าบาน</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>มือจับ</translation>
    </message>
    <message>
        <source>Legs set in by</source>
        <translation>ระยะร่นของขา</translation>
    </message>
    <message>
        <source>Height of the feet</source>
        <translation>ความสูงของขา</translation>
    </message>
    <message>
        <source>Thickness of the legs</source>
        <translation>ความหนาของขา</translation>
    </message>
    <message>
        <source>Oven</source>
        <translation>เตาอบ</translation>
    </message>
    <message>
        <source>Padded seat</source>
        <translation>เบาะนั่งบุนุ่ม</translation>
    </message>
    <message>
        <source>Pedestal</source>
        <translation>ตู้ข้าง</translation>
    </message>
    <message>
        <source>Pillows</source>
        <translation>หมอน</translation>
    </message>
    <message>
        <source>Piping</source>
        <translation>กุ๊นขอบ</translation>
    </message>
    <message>
        <source>Rounding of the edges</source>
        <translation>ความมนของขอบ</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>รูปทรง</translation>
    </message>
    <message>
        <source>Shelf below</source>
        <translation>ชั้นด้านล่าง</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>จำนวนด้าน</translation>
    </message>
    <message>
        <source>Smooth curve</source>
        <translation>เส้นโค้งเรียบ</translation>
    </message>
    <message>
        <source>Stretcher between the legs</source>
        <translation>คานระหว่างขา</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>แบบ</translation>
    </message>
    <message>
        <source>Width of the end</source>
        <translation>ความกว้างของปลาย</translation>
    </message>
    <message>
        <source>Turned posts</source>
        <translation>เสากลึง</translation>
    </message>
    <message>
        <source>Hangs on the wall</source>
        <translation>แขวนบนผนัง</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>เรียบ</translation>
    </message>
    <message>
        <source>Shaker</source>
        <translation>เชคเกอร์</translation>
    </message>
    <message>
        <source>Panelled</source>
        <translation>ลูกฟัก</translation>
    </message>
    <message>
        <source>Slats</source>
        <translation>ซี่ไม้</translation>
    </message>
    <message>
        <source>Louvres</source>
        <translation>บานเกล็ด</translation>
    </message>
    <message>
        <source>Knobs</source>
        <translation>ปุ่มจับ</translation>
    </message>
    <message>
        <source>Cups</source>
        <translation>มือจับถ้วย</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>ขอบจับ</translation>
    </message>
    <message>
        <source>Tapered</source>
        <translation>เรียว</translation>
    </message>
    <message>
        <source>Splayed</source>
        <translation>ขากาง</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>ขาบล็อก</translation>
    </message>
    <message>
        <source>Metal frame</source>
        <translation>โครงโลหะ</translation>
    </message>
    <message>
        <source>Sledge</source>
        <translation>ขาเลื่อน</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>กลม</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>สี่เหลี่ยมจัตุรัส</translation>
    </message>
    <message>
        <source>Rectangular</source>
        <translation>สี่เหลี่ยมผืนผ้า</translation>
    </message>
    <message>
        <source>Soft corners</source>
        <translation>มุมมน</translation>
    </message>
    <message>
        <source>Buns</source>
        <translation>ขาลูกกลม</translation>
    </message>
    <message>
        <source>Tapered underneath</source>
        <translation>เรียวลงด้านล่าง</translation>
    </message>
    <message>
        <source>Bellied</source>
        <translation>โค้งป่อง</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>ตรง</translation>
    </message>
    <message>
        <source>With a rim</source>
        <translation>มีขอบยก</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>แนวตั้ง</translation>
    </message>
    <message>
        <source>Left to right</source>
        <translation>ซ้ายไปขวา</translation>
    </message>
    <message>
        <source>Front to back</source>
        <translation>หน้าไปหลัง</translation>
    </message>
    <message>
        <source>Pyramid</source>
        <translation>พีระมิด</translation>
    </message>
    <message>
        <source>Tulip foot</source>
        <translation>ขาทิวลิป</translation>
    </message>
    <message>
        <source>Writing table</source>
        <translation>โต๊ะเขียนหนังสือ</translation>
    </message>
    <message>
        <source>With pedestals</source>
        <translation>มีตู้ข้าง</translation>
    </message>
    <message>
        <source>Arched</source>
        <translation>โค้งบน</translation>
    </message>
    <message>
        <source>Bow</source>
        <translation>โค้ง</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>ซี่หวี</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>เรียบง่าย</translation>
    </message>
    <message>
        <source>Wooden legs</source>
        <translation>ขาไม้</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>ตาข่าย</translation>
    </message>
    <message>
        <source>Padded</source>
        <translation>บุนุ่ม</translation>
    </message>
    <message>
        <source>Drum</source>
        <translation>ทรงกลอง</translation>
    </message>
    <message>
        <source>Slatted</source>
        <translation>ระแนง</translation>
    </message>
    <message>
        <source>Tufted</source>
        <translation>ดึงดุม</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>ร่องตั้ง</translation>
    </message>
    <message>
        <source>Dome</source>
        <translation>โดม</translation>
    </message>
    <message>
        <source>Globe</source>
        <translation>ลูกโลก</translation>
    </message>
    <message>
        <source>Paper lantern</source>
        <translation>โคมกระดาษ</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>จาน</translation>
    </message>
    <message>
        <source>Tripod</source>
        <translation>สามขา</translation>
    </message>
    <message>
        <source>Tulips</source>
        <translation>ทิวลิป</translation>
    </message>
    <message>
        <source>Daisies</source>
        <translation>เดซี</translation>
    </message>
    <message>
        <source>PNG picture</source>
        <translation>ภาพ PNG</translation>
    </message>
    <message>
        <source>JPEG picture</source>
        <translation>ภาพ JPEG</translation>
    </message>
    <message>
        <source>OpenEXR picture with layers</source>
        <translation>ภาพ OpenEXR พร้อมเลเยอร์</translation>
    </message>
    <message>
        <source>PCX picture of 256 colours</source>
        <translation>ภาพ PCX 256 สี</translation>
    </message>
    <message>
        <source>GIF picture of 256 colours</source>
        <translation>ภาพ GIF 256 สี</translation>
    </message>
    <message>
        <source>The catalog could not be changed: %1</source>
        <translation>เปลี่ยนแคตตาล็อกไม่ได้: %1</translation>
    </message>
    <message>
        <source>%1 is in the catalog</source>
        <translation>%1 อยู่ในแคตตาล็อกแล้ว</translation>
    </message>
    <message>
        <source>&amp;Save as furniture…</source>
        <translation>บันทึกเป็นเฟอร์นิเจอร์(&amp;S)…</translation>
    </message>
    <message>
        <source>Makes one piece of what is selected and keeps it in the catalog</source>
        <translation>รวมสิ่งที่เลือกเป็นชิ้นเดียวและเก็บไว้ในแคตตาล็อก</translation>
    </message>
    <message>
        <source>E&amp;xport own furniture…</source>
        <translation>ส่งออกเฟอร์นิเจอร์ของฉัน(&amp;X)…</translation>
    </message>
    <message>
        <source>Writes your furniture as a library (SH3F) that Sweet Home 3D opens, too</source>
        <translation>เขียนเฟอร์นิเจอร์ของคุณเป็นคลัง (SH3F) ที่ Sweet Home 3D เปิดได้ด้วย</translation>
    </message>
    <message>
        <source>Exported your furniture as %1</source>
        <translation>ส่งออกเฟอร์นิเจอร์ของคุณเป็น %1 แล้ว</translation>
    </message>
    <message>
        <source>Your furniture could not be exported: %1</source>
        <translation>ส่งออกเฟอร์นิเจอร์ของคุณไม่ได้: %1</translation>
    </message>
    <message>
        <source>&amp;Film of</source>
        <translation>ภาพยนตร์ของ(&amp;F)</translation>
    </message>
    <message>
        <source>T&amp;hrough</source>
        <translation>ผ่าน(&amp;H)</translation>
    </message>
    <message>
        <source>Metres a &amp;second</source>
        <translation>เมตรต่อวินาที(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Date</source>
        <translation>วันที่(&amp;D)</translation>
    </message>
    <message>
        <source>F&amp;rom</source>
        <translation>จาก(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>ถึง(&amp;T)</translation>
    </message>
    <message>
        <source>S&amp;econds</source>
        <translation>วินาที(&amp;E)</translation>
    </message>
    <message>
        <source>S&amp;ize</source>
        <translation>ขนาด(&amp;I)</translation>
    </message>
    <message>
        <source>Frames &amp;a second</source>
        <translation>เฟรมต่อวินาที(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>คุณภาพ(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Lamps</source>
        <translation>โคมไฟ(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Points of view</source>
        <translation>มุมกล้อง(&amp;P)</translation>
    </message>
    <message>
        <source>L&amp;ook</source>
        <translation>ลักษณะภาพ(&amp;O)</translation>
    </message>
    <message>
        <source>Proportio&amp;ns</source>
        <translation>สัดส่วน(&amp;N)</translation>
    </message>
    <message>
        <source>Pi&amp;xels</source>
        <translation>พิกเซล(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Keep this point of view</source>
        <translation>เก็บมุมมองนี้(&amp;K)</translation>
    </message>
    <message>
        <source>Keeps where the live view stands as a camera of the home</source>
        <translation>เก็บตำแหน่งของมุมมองสดไว้เป็นกล้องของบ้าน</translation>
    </message>
    <message>
        <source>Own colour</source>
        <translation>สีเดิม</translation>
    </message>
    <message>
        <source>Candle, 2200 K</source>
        <translation>แสงเทียน 2200 K</translation>
    </message>
    <message>
        <source>Warm white, 2700 K</source>
        <translation>ขาวอุ่น 2700 K</translation>
    </message>
    <message>
        <source>Soft white, 3000 K</source>
        <translation>ขาวนวล 3000 K</translation>
    </message>
    <message>
        <source>Neutral white, 4000 K</source>
        <translation>ขาวกลาง 4000 K</translation>
    </message>
    <message>
        <source>Daylight, 6500 K</source>
        <translation>แสงกลางวัน 6500 K</translation>
    </message>
    <message>
        <source>The lights cannot be mixed: %1</source>
        <translation>ผสมแสงไม่ได้: %1</translation>
    </message>
    <message>
        <source>Change lamps</source>
        <translation>เปลี่ยนโคมไฟ</translation>
    </message>
    <message>
        <source>The lamps of the home are as in the picture now</source>
        <translation>โคมไฟในบ้านเป็นเหมือนในภาพแล้ว</translation>
    </message>
    <message>
        <source>&amp;Brightness</source>
        <translation>ความสว่าง(&amp;B)</translation>
    </message>
    <message>
        <source>S&amp;harpness</source>
        <translation>ความคมชัด(&amp;H)</translation>
    </message>
    <message>
        <source>Export in &amp;three dimensions…</source>
        <translation>ส่งออกแบบสามมิติ(&amp;T)…</translation>
    </message>
    <message>
        <source>Writes the home as glTF, for viewers and other 3D programs</source>
        <translation>เขียนบ้านเป็น glTF สำหรับโปรแกรมดูและโปรแกรมสามมิติอื่น ๆ</translation>
    </message>
    <message>
        <source>%1 could not be written: %2</source>
        <translation>เขียน %1 ไม่ได้: %2</translation>
    </message>
    <message>
        <source>Exported the home in three dimensions as %1</source>
        <translation>ส่งออกบ้านแบบสามมิติเป็น %1 แล้ว</translation>
    </message>
</context>
<context>
    <name>idap::AboutDialog</name>
    <message>
        <source>About IDAP</source>
        <translation>เกี่ยวกับ IDAP</translation>
    </message>
    <message>
        <source>Draw or open a home, furnish it, and see it as it would really look. It carries on a DOS program of 1993, the Interior Design Assisting Program.</source>
        <translation>เขียนหรือเปิดแบบบ้าน จัดเฟอร์นิเจอร์ แล้วดูภาพเสมือนจริง โปรแกรมนี้สืบต่อจากโปรแกรมบน DOS ปี 1993 ชื่อ Interior Design Assisting Program</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later: you may use, study, share and change it. It comes without any warranty.</source>
        <translation>ซอฟต์แวร์เสรีภายใต้สัญญาอนุญาต GNU General Public License รุ่น 3 ขึ้นไป คุณใช้ ศึกษา แบ่งปัน และแก้ไขได้ โดยไม่มีการรับประกันใด ๆ</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>ไลบรารี</translation>
    </message>
    <message>
        <source>Furniture and weights</source>
        <translation>เฟอร์นิเจอร์และค่าน้ำหนัก</translation>
    </message>
    <message>
        <source>Furniture libraries name the creator and the licence of each piece in the catalog&apos;s tooltips. Denoising uses the weights of Intel Open Image Denoise (Apache-2.0), where they are installed.</source>
        <translation>คลังเฟอร์นิเจอร์ระบุผู้สร้างและสัญญาอนุญาตของแต่ละชิ้นไว้ในคำแนะนำของแค็ตตาล็อก การลดสัญญาณรบกวนใช้ค่าน้ำหนักของ Intel Open Image Denoise (Apache-2.0) หากติดตั้งไว้</translation>
    </message>
</context>
<context>
    <name>idap::BackgroundDialog</name>
    <message>
        <source>It is not a PNG or JPEG picture.</source>
        <translation>ไม่ใช่ภาพ PNG หรือ JPEG</translation>
    </message>
    <message>
        <source>It is larger than %1 pixels. Make it smaller with a paint program.</source>
        <translation>ภาพใหญ่เกิน %1 พิกเซล โปรดย่อด้วยโปรแกรมแต่งภาพ</translation>
    </message>
    <message>
        <source>It is damaged: %1</source>
        <translation>ไฟล์เสียหาย: %1</translation>
    </message>
    <message>
        <source>No picture yet</source>
        <translation>ยังไม่มีภาพ</translation>
    </message>
    <message>
        <source>Choose a picture of the plan</source>
        <translation>เลือกภาพแปลน</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>รูปภาพ</translation>
    </message>
    <message>
        <source>“%1” cannot be used. %2</source>
        <translation>ใช้ “%1” ไม่ได้ %2</translation>
    </message>
    <message>
        <source>Background picture</source>
        <translation>ภาพพื้นหลัง</translation>
    </message>
    <message>
        <source>A scanned plan (PNG or JPEG) lies under the drawing of this level. Choose it, then click two points on it whose distance you know: it gets its true size.</source>
        <translation>แปลนสแกน (PNG หรือ JPEG) วางอยู่ใต้แบบของชั้นนี้ เลือกภาพ แล้วคลิกสองจุดที่รู้ระยะจริง ภาพจะได้ขนาดจริง</translation>
    </message>
    <message>
        <source>1.  &amp;Choose a picture…</source>
        <translation>1.  เลือกภาพ(&amp;C)…</translation>
    </message>
    <message>
        <source>2.  &amp;Set its size by two points</source>
        <translation>2.  กำหนดขนาดด้วยสองจุด(&amp;S)</translation>
    </message>
    <message>
        <source>3.  &amp;Move it into place</source>
        <translation>3.  ย้ายเข้าตำแหน่ง(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Remove it</source>
        <translation>เอาออก(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Visible</source>
        <translation>แสดง(&amp;V)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>ปิด</translation>
    </message>
    <message>
        <source>Click two points on the plan, then type the length between them</source>
        <translation>คลิกสองจุดบนแปลน แล้วพิมพ์ระยะระหว่างจุด</translation>
    </message>
    <message>
        <source>Drag it where the drawing is, or the drawing will be</source>
        <translation>ลากไปยังตำแหน่งที่มีแบบ หรือที่จะเขียนแบบ</translation>
    </message>
    <message>
        <source>Takes it from this level; undo brings it back</source>
        <translation>เอาออกจากชั้นนี้ เลิกทำเพื่อเอากลับมาได้</translation>
    </message>
</context>
<context>
    <name>idap::BackgroundJob</name>
    <message>
        <source>There is not enough memory for it.</source>
        <translation>หน่วยความจำไม่พอ</translation>
    </message>
</context>
<context>
    <name>idap::CameraList</name>
    <message>
        <source>Double click for a picture from here; F2 renames it</source>
        <translation>ดับเบิลคลิกเพื่อเรนเดอร์จากมุมนี้ กด F2 เปลี่ยนชื่อ</translation>
    </message>
    <message>
        <source>The whole home from above, without ceilings</source>
        <translation>ทั้งบ้านจากด้านบน ไม่มีเพดาน</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>จากด้านบน</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>มุม %1</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>ภาพ</translation>
    </message>
    <message>
        <source>Trace a picture from this point of view</source>
        <translation>เรนเดอร์ภาพจากมุมกล้องนี้</translation>
    </message>
    <message>
        <source>New</source>
        <translation>ใหม่</translation>
    </message>
    <message>
        <source>Place another point of view on the plan</source>
        <translation>วางกล้องอีกตัวบนแปลน</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>เปลี่ยนชื่อ</translation>
    </message>
    <message>
        <source>Give it a name (F2)</source>
        <translation>ตั้งชื่อ (F2)</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>ทำสำเนา</translation>
    </message>
    <message>
        <source>Another one at the same place, to be changed</source>
        <translation>อีกตัวที่ตำแหน่งเดียวกัน เพื่อนำไปปรับ</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>ขึ้น</translation>
    </message>
    <message>
        <source>Earlier in the list</source>
        <translation>เลื่อนขึ้นในรายการ</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>ลง</translation>
    </message>
    <message>
        <source>Later in the list</source>
        <translation>เลื่อนลงในรายการ</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>ลบ</translation>
    </message>
    <message>
        <source>Take this point of view out of the home</source>
        <translation>ลบมุมกล้องนี้ออกจากบ้าน</translation>
    </message>
    <message>
        <source>Points of view</source>
        <translation>มุมกล้อง</translation>
    </message>
</context>
<context>
    <name>idap::CatalogPanel</name>
    <message>
        <source>Search furniture</source>
        <translation>ค้นหาเฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>Names, tags, categories and creators, in English or Thai. Enter places the first piece found</source>
        <translation>ชื่อ แท็ก หมวดหมู่ และผู้สร้าง เป็นไทยหรืออังกฤษ กด Enter เพื่อวางชิ้นแรกที่พบ</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>ขนาด</translation>
    </message>
    <message>
        <source>Show only pieces that fit into a space</source>
        <translation>แสดงเฉพาะชิ้นที่ใส่ในที่ว่างได้</translation>
    </message>
    <message>
        <source>W</source>
        <comment>width</comment>
        <translation>ก</translation>
    </message>
    <message>
        <source>D</source>
        <comment>depth</comment>
        <translation>ล</translation>
    </message>
    <message>
        <source>H</source>
        <comment>height</comment>
        <translation>ส</translation>
    </message>
    <message>
        <source>At most this wide; empty: any width</source>
        <translation>กว้างไม่เกินนี้ ว่าง: เท่าใดก็ได้</translation>
    </message>
    <message>
        <source>At most this deep; empty: any depth</source>
        <translation>ลึกไม่เกินนี้ ว่าง: เท่าใดก็ได้</translation>
    </message>
    <message>
        <source>At most this high; empty: any height</source>
        <translation>สูงไม่เกินนี้ ว่าง: เท่าใดก็ได้</translation>
    </message>
    <message>
        <source>Any size</source>
        <translation>ทุกขนาด</translation>
    </message>
    <message>
        <source>Kinds of furniture</source>
        <translation>ประเภทเฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>Categories</source>
        <translation>หมวดหมู่</translation>
    </message>
    <message>
        <source>Furniture</source>
        <translation>เฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>Nothing found. Try fewer words, another category or any size.</source>
        <translation>ไม่พบ ลองใช้คำน้อยลง เปลี่ยนหมวดหมู่ หรือเลือกทุกขนาด</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>นำเข้า…</translation>
    </message>
    <message>
        <source>Bring in a furniture library or a model file of your own</source>
        <translation>นำเข้าคลังเฟอร์นิเจอร์หรือไฟล์โมเดลของคุณเอง</translation>
    </message>
    <message>
        <source>Reading furniture libraries</source>
        <translation>กำลังอ่านคลังเฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>Reading libraries…</source>
        <translation>กำลังอ่านคลัง…</translation>
    </message>
    <message>
        <source>Place in the room</source>
        <translation>วางในห้อง</translation>
    </message>
    <message>
        <source>Puts it where it fits</source>
        <translation>วางในที่ที่เหมาะ</translation>
    </message>
    <message>
        <source>Place with the pointer</source>
        <translation>วางด้วยเมาส์</translation>
    </message>
    <message>
        <source>It follows the pointer and stays where you click, as often as you like</source>
        <translation>ตามเมาส์และวางตรงที่คลิก กี่ครั้งก็ได้</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>รายการโปรด</translation>
    </message>
    <message>
        <source>Price: %1 %2</source>
        <translation>ราคา: %1 %2</translation>
    </message>
    <message>
        <source>By %1</source>
        <translation>โดย %1</translation>
    </message>
    <message>
        <source>Licence: %1</source>
        <translation>สัญญาอนุญาต: %1</translation>
    </message>
    <message>
        <source>Library: %1</source>
        <translation>คลัง: %1</translation>
    </message>
    <message>
        <source>Pieces: %1</source>
        <translation>จำนวนชิ้น: %1</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>แก้ไข…</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>ลบ…</translation>
    </message>
    <message>
        <source>Delete furniture</source>
        <translation>ลบเฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>Delete %1 from the catalog?</source>
        <translation>ลบ %1 ออกจากแคตตาล็อกหรือไม่</translation>
    </message>
    <message>
        <source>Homes that it stands in keep it.</source>
        <translation>บ้านที่วางชิ้นนี้ไว้ยังคงมีอยู่</translation>
    </message>
</context>
<context>
    <name>idap::CategoryList</name>
    <message>
        <source>All furniture</source>
        <translation>เฟอร์นิเจอร์ทั้งหมด</translation>
    </message>
    <message>
        <source>Recently used</source>
        <translation>ใช้ล่าสุด</translation>
    </message>
    <message>
        <source>From libraries</source>
        <translation>จากคลัง</translation>
    </message>
    <message>
        <source>Favourites</source>
        <translation>รายการโปรด</translation>
    </message>
</context>
<context>
    <name>idap::ChipRow</name>
    <message>
        <source>Show only pieces tagged “%1”</source>
        <translation>แสดงเฉพาะชิ้นที่มีแท็ก “%1”</translation>
    </message>
</context>
<context>
    <name>idap::ColorButton</name>
    <message>
        <source>Used last</source>
        <translation>ใช้ล่าสุด</translation>
    </message>
    <message>
        <source>The colour as #rrggbb, from a paint chart for example. Enter takes it.</source>
        <translation>สีในรูป #rrggbb เช่นจากแผ่นตัวอย่างสี กด Enter เพื่อใช้</translation>
    </message>
    <message>
        <source>More colours…</source>
        <translation>สีเพิ่มเติม…</translation>
    </message>
    <message>
        <source>No colour of its own</source>
        <translation>ไม่มีสีของตัวเอง</translation>
    </message>
    <message>
        <source>Several values</source>
        <translation>หลายค่า</translation>
    </message>
</context>
<context>
    <name>idap::CompareView</name>
    <message>
        <source>Tick a point of view and press Ray Trace. Every picture is kept below, with the home.</source>
        <translation>ทำเครื่องหมายมุมกล้องแล้วกดเรนเดอร์ ทุกภาพจะเก็บไว้ด้านล่างพร้อมกับบ้าน</translation>
    </message>
</context>
<context>
    <name>idap::CompassFace</name>
    <message>
        <source>N</source>
        <translation>เหนือ</translation>
    </message>
</context>
<context>
    <name>idap::FileFlow</name>
    <message>
        <source>Homes</source>
        <translation>บ้าน</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>เปิด</translation>
    </message>
    <message>
        <source>“%1” could not be opened.</source>
        <translation>เปิด “%1” ไม่ได้</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>บันทึก</translation>
    </message>
    <message>
        <source>“%1” could not be saved.</source>
        <translation>บันทึก “%1” ไม่ได้</translation>
    </message>
    <message>
        <source>Your work is still open here and nothing of it is lost. Save it in another place, or free some space and try again.</source>
        <translation>งานของคุณยังเปิดอยู่และไม่มีอะไรสูญหาย โปรดบันทึกที่อื่น หรือเพิ่มพื้นที่ว่างแล้วลองอีกครั้ง</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>บันทึกเป็น(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>ลองอีกครั้ง(&amp;T)</translation>
    </message>
    <message>
        <source>“%1” was changed by another program since you opened it.</source>
        <translation>“%1” ถูกโปรแกรมอื่นแก้ไขหลังจากที่คุณเปิด</translation>
    </message>
    <message>
        <source>Saving here would replace those changes with yours.</source>
        <translation>การบันทึกที่นี่จะแทนที่การแก้ไขนั้นด้วยของคุณ</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>แทนที่(&amp;R)</translation>
    </message>
    <message>
        <source>New home</source>
        <translation>บ้านใหม่</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>ห้อง</translation>
    </message>
    <message>
        <source>Open a home</source>
        <translation>เปิดบ้าน</translation>
    </message>
    <message>
        <source>“%1” cannot be written in its own format, so the home is saved as an IDAP home beside it. The original stays as it is.</source>
        <translation>“%1” บันทึกในรูปแบบเดิมไม่ได้ จึงบันทึกเป็นบ้าน IDAP ไว้ข้างกัน ไฟล์ต้นฉบับยังเหมือนเดิม</translation>
    </message>
    <message>
        <source>Save the home as</source>
        <translation>บันทึกบ้านเป็น</translation>
    </message>
    <message>
        <source>IDAP homes</source>
        <translation>บ้าน IDAP</translation>
    </message>
    <message>
        <source>Save a compact copy</source>
        <translation>บันทึกสำเนาแบบย่อ</translation>
    </message>
    <message>
        <source>compact</source>
        <translation>ย่อ</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>กำลังบันทึก %1</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>ยังไม่ได้บันทึก</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>บันทึกการเปลี่ยนแปลงของ “%1” หรือไม่</translation>
    </message>
    <message>
        <source>Without saving, what you did since the last time is lost.</source>
        <translation>ถ้าไม่บันทึก สิ่งที่ทำหลังการบันทึกครั้งก่อนจะหายไป</translation>
    </message>
    <message>
        <source>a new home</source>
        <translation>บ้านใหม่</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>กู้คืน</translation>
    </message>
    <message>
        <source>The program did not end in order last time. A copy of %1 from %2 is there.</source>
        <translation>ครั้งก่อนโปรแกรมปิดไม่ปกติ มีสำเนาของ %1 เมื่อ %2</translation>
    </message>
    <message>
        <source>Restored, it opens as unsaved work; the file itself is not touched.</source>
        <translation>เมื่อกู้คืนจะเปิดเป็นงานที่ยังไม่บันทึก ไฟล์เดิมไม่ถูกแตะต้อง</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>กู้คืน(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Throw away</source>
        <translation>ทิ้ง(&amp;T)</translation>
    </message>
    <message>
        <source>Ask &amp;later</source>
        <translation>ถามภายหลัง(&amp;L)</translation>
    </message>
</context>
<context>
    <name>idap::FilmWindow</name>
    <message>
        <source>Film</source>
        <translation>ภาพยนตร์</translation>
    </message>
    <message>
        <source>A walk through the home</source>
        <translation>เดินชมบ้าน</translation>
    </message>
    <message>
        <source>A day of sunlight</source>
        <translation>แสงแดดตลอดวัน</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>ร่าง</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>ดี</translation>
    </message>
    <message>
        <source>Better</source>
        <translation>ดีกว่า</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>ดีที่สุด</translation>
    </message>
    <message>
        <source>As in the home</source>
        <translation>ตามในบ้าน</translation>
    </message>
    <message>
        <source>All on</source>
        <translation>เปิดทั้งหมด</translation>
    </message>
    <message>
        <source>All off</source>
        <translation>ปิดทั้งหมด</translation>
    </message>
    <message>
        <source>The points of view that are ticked, in this order; a day is filmed from the first</source>
        <translation>มุมกล้องที่ทำเครื่องหมายตามลำดับนี้ แสงแดดตลอดวันถ่ายจากมุมแรก</translation>
    </message>
    <message>
        <source>Points of view</source>
        <translation>มุมกล้อง</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>ก่อนหน้า</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>ถัดไป</translation>
    </message>
    <message>
        <source>Stops, and keeps the film so far</source>
        <translation>หยุดและเก็บภาพยนตร์เท่าที่ทำแล้ว</translation>
    </message>
    <message>
        <source>The film shows here while it is made.</source>
        <translation>ภาพยนตร์จะแสดงที่นี่ขณะสร้าง</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>กล้อง %1</translation>
    </message>
    <message>
        <source>tick a point of view to film from, or add cameras (C)</source>
        <translation>ทำเครื่องหมายมุมกล้องที่จะถ่าย หรือเพิ่มกล้อง (C)</translation>
    </message>
    <message>
        <source>%1 seconds of film; making it takes about %2 min.</source>
        <translation>ภาพยนตร์ %1 วินาที ใช้เวลาสร้างประมาณ %2 นาที</translation>
    </message>
    <message>
        <source>Make the film</source>
        <translation>สร้างภาพยนตร์</translation>
    </message>
    <message>
        <source>Films (*.mp4)</source>
        <translation>ภาพยนตร์ (*.mp4)</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>บ้าน</translation>
    </message>
    <message>
        <source>Making a film</source>
        <translation>กำลังสร้างภาพยนตร์</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>เหลือ %1</translation>
    </message>
    <message>
        <source>preparing…</source>
        <translation>กำลังเตรียม…</translation>
    </message>
    <message>
        <source>&amp;Make the film…</source>
        <translation>สร้างภาพยนตร์(&amp;M)…</translation>
    </message>
    <message>
        <source>St&amp;op</source>
        <translation>หยุด(&amp;O)</translation>
    </message>
</context>
<context>
    <name>idap::FinishPanel</name>
    <message>
        <source>Search finishes</source>
        <translation>ค้นหาวัสดุ</translation>
    </message>
    <message>
        <source>Finishes</source>
        <translation>วัสดุ</translation>
    </message>
    <message>
        <source>Drag one onto a wall, a floor or a piece. A double click gives it to what is selected.</source>
        <translation>ลากไปวางบนผนัง พื้น หรือเฟอร์นิเจอร์ ดับเบิลคลิกเพื่อใช้กับสิ่งที่เลือก</translation>
    </message>
</context>
<context>
    <name>idap::FurnitureList</name>
    <message>
        <source>Filter</source>
        <translation>กรอง</translation>
    </message>
    <message>
        <source>Show only pieces whose name, kind, level or creator holds these words</source>
        <translation>แสดงเฉพาะชิ้นที่ชื่อ ชนิด ชั้น หรือผู้สร้างมีคำเหล่านี้</translation>
    </message>
    <message>
        <source>Furniture, doors and windows</source>
        <translation>เฟอร์นิเจอร์ ประตู และหน้าต่าง</translation>
    </message>
    <message>
        <source>Pieces: %1</source>
        <translation>จำนวนชิ้น: %1</translation>
    </message>
    <message>
        <source>Total %1 %2</source>
        <translation>รวม %1 %2</translation>
    </message>
    <message>
        <source>Usual columns</source>
        <translation>คอลัมน์ปกติ</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>เปลี่ยนชื่อ</translation>
    </message>
</context>
<context>
    <name>idap::GalleryList</name>
    <message>
        <source>Picture</source>
        <translation>ภาพ</translation>
    </message>
    <message>
        <source>Classic, as in 1993</source>
        <translation>คลาสสิกแบบปี 1993</translation>
    </message>
    <message>
        <source>Made %1</source>
        <translation>สร้างเมื่อ %1</translation>
    </message>
    <message>
        <source>Reading a picture</source>
        <translation>กำลังอ่านภาพ</translation>
    </message>
    <message>
        <source>Samples a pixel: %1</source>
        <translation>ตัวอย่างต่อพิกเซล: %1</translation>
    </message>
</context>
<context>
    <name>idap::HintLine</name>
    <message>
        <source>Furnish the room: drag furniture from the catalog on the left into a plane, or choose it there and press Enter.</source>
        <translation>จัดห้อง: ลากเฟอร์นิเจอร์จากแค็ตตาล็อกทางซ้ายลงในระนาบ หรือเลือกแล้วกด Enter</translation>
    </message>
</context>
<context>
    <name>idap::HomeFile</name>
    <message>
        <source>Reading %1</source>
        <translation>กำลังอ่าน %1</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>กำลังบันทึก %1</translation>
    </message>
</context>
<context>
    <name>idap::ImportDialog</name>
    <message>
        <source>Import furniture</source>
        <translation>นำเข้าเฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>Another file</source>
        <translation>ไฟล์อื่น</translation>
    </message>
    <message>
        <source>Add to the catalog</source>
        <translation>เพิ่มลงแค็ตตาล็อก</translation>
    </message>
    <message>
        <source>Put into the home</source>
        <translation>วางในบ้าน</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>กำลังอ่าน %1</translation>
    </message>
    <message>
        <source>Copying %1</source>
        <translation>กำลังคัดลอก %1</translation>
    </message>
</context>
<context>
    <name>idap::ImportStart</name>
    <message>
        <source>Drop a file here, or choose one.

A furniture library (SH3F) becomes part of the catalog. A model (OBJ, 3DS, DAE, glTF, STL, or a ZIP with one of these) becomes a piece of this home.</source>
        <translation>ลากไฟล์มาวางที่นี่ หรือเลือกไฟล์

คลังเฟอร์นิเจอร์ (SH3F) จะเพิ่มลงในแค็ตตาล็อก ส่วนโมเดล (OBJ, 3DS, DAE, glTF, STL หรือ ZIP ที่มีไฟล์เหล่านี้) จะเป็นชิ้นหนึ่งของบ้านนี้</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>เลือกไฟล์…</translation>
    </message>
    <message>
        <source>Look for a furniture library or a model on this computer</source>
        <translation>หาคลังเฟอร์นิเจอร์หรือโมเดลในคอมพิวเตอร์นี้</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>หยุด</translation>
    </message>
    <message>
        <source>Import furniture</source>
        <translation>นำเข้าเฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>Furniture</source>
        <translation>เฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>ทุกไฟล์</translation>
    </message>
</context>
<context>
    <name>idap::JobIndicator</name>
    <message>
        <source>%1 s</source>
        <translation>%1 วินาที</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 นาที</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>เหลือ %1</translation>
    </message>
    <message>
        <source>Stop this</source>
        <translation>หยุดงานนี้</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>หยุด</translation>
    </message>
</context>
<context>
    <name>idap::JobList</name>
    <message>
        <source>Look at it while it is made</source>
        <translation>ดูขณะกำลังสร้าง</translation>
    </message>
    <message>
        <source>Pause, and go on</source>
        <translation>หยุดพักและทำต่อ</translation>
    </message>
    <message>
        <source>Stop here and keep the picture as it is</source>
        <translation>หยุดตรงนี้และเก็บภาพไว้ตามที่เป็น</translation>
    </message>
    <message>
        <source>Give this picture up</source>
        <translation>ยกเลิกภาพนี้</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>รออยู่</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>หยุดพัก</translation>
    </message>
    <message>
        <source>keeping…</source>
        <translation>กำลังเก็บ…</translation>
    </message>
    <message>
        <source>preparing…</source>
        <translation>กำลังเตรียม…</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>เหลือ %1</translation>
    </message>
</context>
<context>
    <name>idap::KeysDialog</name>
    <message>
        <source>Keys</source>
        <translation>ปุ่มลัด</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>ค้นหา</translation>
    </message>
    <message>
        <source>What they do</source>
        <translation>หน้าที่</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>ทุกที่</translation>
    </message>
</context>
<context>
    <name>idap::LengthField</name>
    <message>
        <source>“%1” is not a length. Write a number, with a unit if you like, or a sum: 120, 3.25 m, 10&apos;8&quot;, 120+15.</source>
        <translation>“%1” ไม่ใช่ความยาว พิมพ์ตัวเลข ใส่หน่วยก็ได้ หรือผลบวก: 120, 3.25 m, 10&apos;8&quot;, 120+15</translation>
    </message>
</context>
<context>
    <name>idap::LevelBar</name>
    <message>
        <source>Ground floor</source>
        <translation>ชั้นล่าง</translation>
    </message>
    <message>
        <source>Draw on this level; a double click changes its name and heights</source>
        <translation>เขียนบนชั้นนี้ ดับเบิลคลิกเพื่อเปลี่ยนชื่อและความสูง</translation>
    </message>
    <message>
        <source>Add a level above this one</source>
        <translation>เพิ่มชั้นเหนือชั้นนี้</translation>
    </message>
    <message>
        <source>Add level</source>
        <translation>เพิ่มชั้น</translation>
    </message>
</context>
<context>
    <name>idap::LevelDialog</name>
    <message>
        <source>Level</source>
        <translation>ชั้น</translation>
    </message>
    <message>
        <source>&amp;Height of the rooms</source>
        <translation>ความสูงห้อง(&amp;H)</translation>
    </message>
    <message>
        <source>From the floor to the ceiling; new walls are this high</source>
        <translation>จากพื้นถึงเพดาน ผนังใหม่จะสูงเท่านี้</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>ชื่อ(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Elevation</source>
        <translation>ระดับ(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Floor thickness</source>
        <translation>ความหนาพื้น(&amp;F)</translation>
    </message>
    <message>
        <source>Of the top of its floor above the ground</source>
        <translation>ระดับผิวพื้นของชั้นเหนือพื้นดิน</translation>
    </message>
    <message>
        <source>Of the slab under this level</source>
        <translation>ของแผ่นพื้นใต้ชั้นนี้</translation>
    </message>
    <message>
        <source>&amp;Visible</source>
        <translation>แสดง(&amp;V)</translation>
    </message>
    <message>
        <source>Seen in pictures and, faintly, under the level above</source>
        <translation>เห็นในภาพ และเห็นจาง ๆ ใต้ชั้นที่อยู่เหนือขึ้นไป</translation>
    </message>
    <message>
        <source>&amp;In use</source>
        <translation>ใช้งาน(&amp;I)</translation>
    </message>
    <message>
        <source>Counts when the home is built; a level kept for later does not</source>
        <translation>นับรวมเมื่อสร้างบ้าน ชั้นที่เก็บไว้ภายหลังไม่นับ</translation>
    </message>
</context>
<context>
    <name>idap::LibraryPage</name>
    <message>
        <source>Pieces: %1</source>
        <translation>จำนวนชิ้น: %1</translation>
    </message>
    <message>
        <source>Licence: %1</source>
        <translation>สัญญาอนุญาต: %1</translation>
    </message>
    <message>
        <source>%1 more cannot be used: %2</source>
        <translation>อีก %1 ชิ้นใช้ไม่ได้: %2</translation>
    </message>
    <message>
        <source>You have a library %1 already. It will be replaced by this one.</source>
        <translation>มีคลัง %1 อยู่แล้ว จะถูกแทนที่ด้วยคลังนี้</translation>
    </message>
</context>
<context>
    <name>idap::LightMixer</name>
    <message>
        <source>Lights of this picture</source>
        <translation>แสงของภาพนี้</translation>
    </message>
    <message>
        <source>&amp;Keep as a picture</source>
        <translation>เก็บเป็นภาพ(&amp;K)</translation>
    </message>
    <message>
        <source>Puts the mix into the gallery, beside the picture it was made of</source>
        <translation>เก็บภาพที่ผสมแสงแล้วไว้ในแกลเลอรี ข้างภาพต้นฉบับ</translation>
    </message>
    <message>
        <source>Set the &amp;home&apos;s lamps so</source>
        <translation>ตั้งโคมไฟในบ้านตามนี้(&amp;H)</translation>
    </message>
    <message>
        <source>Dims, recolours and switches the lamps of the home as they are here; can be undone</source>
        <translation>หรี่ เปลี่ยนสี และเปิดปิดโคมไฟในบ้านตามที่ตั้งไว้ที่นี่ เลิกทำได้</translation>
    </message>
    <message>
        <source>As the picture &amp;was</source>
        <translation>กลับเป็นภาพเดิม(&amp;W)</translation>
    </message>
    <message>
        <source>The light of this picture is no longer known. Make it again to mix its lights.</source>
        <translation>ไม่มีข้อมูลแสงของภาพนี้แล้ว สร้างภาพใหม่อีกครั้งเพื่อผสมแสง</translation>
    </message>
    <message>
        <source>This picture keeps no light by itself.</source>
        <translation>ภาพนี้ไม่ได้เก็บแสงแต่ละดวงแยกไว้</translation>
    </message>
    <message>
        <source>Taking the lights apart…</source>
        <translation>กำลังแยกแสงแต่ละดวง…</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>ท้องฟ้า</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>ดวงอาทิตย์</translation>
    </message>
    <message>
        <source>%1 % of the picture&apos;s light</source>
        <translation>%1 % ของแสงในภาพ</translation>
    </message>
    <message>
        <source>Strength of %1</source>
        <translation>ความแรงของ %1</translation>
    </message>
    <message>
        <source>Colour of %1</source>
        <translation>สีของ %1</translation>
    </message>
    <message>
        <source>Taking the lights apart</source>
        <translation>กำลังแยกแสงแต่ละดวง</translation>
    </message>
</context>
<context>
    <name>idap::LightPopup</name>
    <message>
        <source>Date</source>
        <translation>วันที่</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>แจ่มใส</translation>
    </message>
    <message>
        <source>Partly cloudy</source>
        <translation>มีเมฆบางส่วน</translation>
    </message>
    <message>
        <source>Overcast</source>
        <translation>เมฆเต็มท้องฟ้า</translation>
    </message>
    <message>
        <source>Weather</source>
        <translation>สภาพอากาศ</translation>
    </message>
    <message>
        <source>EV</source>
        <translation>EV</translation>
    </message>
    <message>
        <source>Brighter or darker than the automatic exposure, in stops</source>
        <translation>สว่างหรือมืดกว่าค่าแสงอัตโนมัติ เป็นสต็อป</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>ค่าแสง</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>โคมไฟ</translation>
    </message>
    <message>
        <source>Brightness of %1</source>
        <translation>ความสว่างของ %1</translation>
    </message>
    <message>
        <source>This home has no lamps yet.</source>
        <translation>บ้านนี้ยังไม่มีโคมไฟ</translation>
    </message>
    <message>
        <source>All lamps on</source>
        <translation>เปิดไฟทั้งหมด</translation>
    </message>
    <message>
        <source>All lamps off</source>
        <translation>ปิดไฟทั้งหมด</translation>
    </message>
</context>
<context>
    <name>idap::LivePanel</name>
    <message>
        <source>From above</source>
        <translation>จากด้านบน</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>กล้อง %1</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>ที่นี่</translation>
    </message>
    <message>
        <source>Coarse</source>
        <translation>หยาบ</translation>
    </message>
    <message>
        <source>Clean</source>
        <translation>คมชัด</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 ตัวอย่าง</translation>
    </message>
    <message>
        <source>Where the view is seen from</source>
        <translation>มองจากจุดใด</translation>
    </message>
    <message>
        <source>Circle: drag turns the home, the wheel comes nearer, the middle button shifts</source>
        <translation>วนรอบ: ลากเพื่อหมุนบ้าน ล้อเมาส์เพื่อเข้าใกล้ ปุ่มกลางเพื่อเลื่อน</translation>
    </message>
    <message>
        <source>Walk: drag looks around; W A S D walk, Q and E lower and raise the eye, Shift hurries</source>
        <translation>เดิน: ลากเพื่อมองรอบ W A S D เพื่อเดิน Q และ E ลดและยกระดับสายตา Shift เพื่อเร่ง</translation>
    </message>
    <message>
        <source>Cut away the walls and ceilings that are in the way of an eye outside</source>
        <translation>ตัดผนังและฝ้าที่บังสายตาจากภายนอกออก</translation>
    </message>
    <message>
        <source>Walls stop the walker; doors let them through</source>
        <translation>ผนังกั้นผู้เดิน ประตูให้ผ่านได้</translation>
    </message>
    <message>
        <source>Keep this point of view in the home</source>
        <translation>เก็บมุมมองนี้ไว้ในบ้าน</translation>
    </message>
    <message>
        <source>Date, weather, lamps and exposure</source>
        <translation>วันที่ สภาพอากาศ โคมไฟ และค่าแสง</translation>
    </message>
    <message>
        <source>Time of day</source>
        <translation>เวลาของวัน</translation>
    </message>
    <message>
        <source>How fine the view is; it becomes clean while nothing changes</source>
        <translation>ความละเอียดของมุมมอง ภาพจะคมชัดขึ้นเมื่อไม่มีการเปลี่ยนแปลง</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>มุมมอง %1</translation>
    </message>
</context>
<context>
    <name>idap::MainWindow</name>
    <message>
        <source>Wall</source>
        <translation>ผนัง</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>ห้อง</translation>
    </message>
    <message>
        <source>%1 selected</source>
        <translation>เลือก %1 รายการ</translation>
    </message>
    <message>
        <source>Furniture</source>
        <translation>เฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>Points of view</source>
        <translation>มุมกล้อง</translation>
    </message>
    <message>
        <source>Messages (%1)</source>
        <translation>ข้อความแจ้ง (%1)</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>ข้อความแจ้ง</translation>
    </message>
    <message>
        <source>Catalog</source>
        <translation>แค็ตตาล็อก</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>คุณสมบัติ</translation>
    </message>
    <message>
        <source>Lists</source>
        <translation>รายการ</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>คำสั่ง</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>เครื่องมือ</translation>
    </message>
    <message>
        <source>What is selected</source>
        <translation>สิ่งที่เลือก</translation>
    </message>
    <message>
        <source>Where the pointer is</source>
        <translation>ตำแหน่งเมาส์</translation>
    </message>
    <message>
        <source>The scale of the plan on this screen</source>
        <translation>มาตราส่วนแปลนบนจอนี้</translation>
    </message>
    <message>
        <source>Export the furniture list</source>
        <translation>ส่งออกรายการเฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>ตาราง</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>ยินดีต้อนรับ</translation>
    </message>
    <message>
        <source>Finishes</source>
        <translation>วัสดุ</translation>
    </message>
    <message>
        <source>Export own furniture</source>
        <translation>ส่งออกเฟอร์นิเจอร์ของฉัน</translation>
    </message>
    <message>
        <source>Furniture libraries</source>
        <translation>คลังเฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>My furniture</source>
        <translation>เฟอร์นิเจอร์ของฉัน</translation>
    </message>
    <message>
        <source>Export in three dimensions</source>
        <translation>ส่งออกแบบสามมิติ</translation>
    </message>
    <message>
        <source>Scenes</source>
        <translation>ฉาก</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>กำลังส่งออก %1</translation>
    </message>
</context>
<context>
    <name>idap::MaterialPicker</name>
    <message>
        <source>As it comes</source>
        <translation>ตามเดิม</translation>
    </message>
    <message>
        <source>Several finishes</source>
        <translation>หลายผิววัสดุ</translation>
    </message>
    <message>
        <source>%1, tinted</source>
        <translation>%1, ย้อมสี</translation>
    </message>
    <message>
        <source>Picture for this face</source>
        <translation>ภาพสำหรับผิวนี้</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>รูปภาพ (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>ทุกไฟล์ (*)</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2.</source>
        <translation>เปิด %1 ไม่ได้: %2</translation>
    </message>
    <message>
        <source>%1 is too large: pictures may have up to 64 MB.</source>
        <translation>%1 ใหญ่เกินไป: ภาพต้องไม่เกิน 64 MB</translation>
    </message>
    <message>
        <source>%1 is not a picture this program can read.</source>
        <translation>%1 ไม่ใช่ภาพที่โปรแกรมนี้อ่านได้</translation>
    </message>
</context>
<context>
    <name>idap::MaterialPopup</name>
    <message>
        <source>Search materials</source>
        <translation>ค้นหาวัสดุ</translation>
    </message>
    <message>
        <source>Takes material, colour and picture away again.</source>
        <translation>เอาวัสดุ สี และภาพออก</translation>
    </message>
    <message>
        <source>None</source>
        <translation>ไม่มี</translation>
    </message>
    <message>
        <source>The material&apos;s</source>
        <translation>ตามวัสดุ</translation>
    </message>
    <message>
        <source>A colour of its own; with a material, it is tinted.</source>
        <translation>สีของตัวเอง ถ้ามีวัสดุ วัสดุจะถูกย้อมสี</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>สี</translation>
    </message>
    <message>
        <source>Another file…</source>
        <translation>ไฟล์อื่น…</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>จากไฟล์…</translation>
    </message>
    <message>
        <source>Lays a picture over the face, a photograph of tiles for example.</source>
        <translation>ปูภาพทับผิว เช่น ภาพถ่ายกระเบื้อง</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>ภาพ</translation>
    </message>
    <message>
        <source>Picture width</source>
        <translation>ความกว้างภาพ</translation>
    </message>
    <message>
        <source>What one copy of the picture covers.</source>
        <translation>ระยะที่ภาพหนึ่งชุดครอบคลุม</translation>
    </message>
    <message>
        <source>Picture height</source>
        <translation>ความสูงภาพ</translation>
    </message>
    <message>
        <source>Picture angle</source>
        <translation>มุมภาพ</translation>
    </message>
    <message>
        <source>From matt to a mirror.</source>
        <translation>ตั้งแต่ด้านจนเงาเหมือนกระจก</translation>
    </message>
    <message>
        <source>Usual</source>
        <translation>ปกติ</translation>
    </message>
    <message>
        <source>Shininess</source>
        <translation>ความเงา</translation>
    </message>
</context>
<context>
    <name>idap::MessageList</name>
    <message>
        <source>Note</source>
        <translation>หมายเหตุ</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>คำเตือน</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>ข้อผิดพลาด</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>คัดลอก</translation>
    </message>
    <message>
        <source>Copy the selected messages, or all of them, as text</source>
        <translation>คัดลอกข้อความแจ้งที่เลือกหรือทั้งหมด</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>ล้าง</translation>
    </message>
    <message>
        <source>Empty this list</source>
        <translation>ล้างรายการนี้</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>ข้อความแจ้ง</translation>
    </message>
</context>
<context>
    <name>idap::ModelPage</name>
    <message>
        <source>Furniture</source>
        <translation>เฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>โคมไฟ</translation>
    </message>
    <message>
        <source>Door</source>
        <translation>ประตู</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>หน้าต่าง</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>เมตร</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>เซนติเมตร</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>มิลลิเมตร</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>นิ้ว</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>−Y</source>
        <translation>−Y</translation>
    </message>
    <message>
        <source>−Z</source>
        <translation>−Z</translation>
    </message>
    <message>
        <source>−X</source>
        <translation>−X</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>ชื่อ</translation>
    </message>
    <message>
        <source>Category</source>
        <translation>หมวดหมู่</translation>
    </message>
    <message>
        <source>It is</source>
        <translation>เป็น</translation>
    </message>
    <message>
        <source>Made in</source>
        <translation>หน่วยในไฟล์</translation>
    </message>
    <message>
        <source>Up is</source>
        <translation>แกนที่ชี้ขึ้น</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>กว้าง</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>ลึก</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>สูง</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>ระดับจากพื้น</translation>
    </message>
    <message>
        <source>What one unit of the file stands for: sets the size</source>
        <translation>หนึ่งหน่วยในไฟล์แทนอะไร: กำหนดขนาด</translation>
    </message>
    <message>
        <source>If the piece lies on its back, choose another axis</source>
        <translation>ถ้าชิ้นนี้นอนหงาย เลือกแกนอื่น</translation>
    </message>
    <message>
        <source>Lamps give light; doors and windows go into walls</source>
        <translation>โคมไฟให้แสง ประตูและหน้าต่างอยู่ในผนัง</translation>
    </message>
    <message>
        <source>Keep proportions</source>
        <translation>คงสัดส่วน</translation>
    </message>
    <message>
        <source>Width, depth and height change together</source>
        <translation>กว้าง ลึก สูง เปลี่ยนไปพร้อมกัน</translation>
    </message>
    <message>
        <source>Of its base above the floor</source>
        <translation>ความสูงของฐานเหนือพื้น</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 สามเหลี่ยม</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>ส่วนประกอบ</translation>
    </message>
    <message>
        <source>Turn it by 90° to the left, until its front looks at you</source>
        <translation>หมุนไปทางซ้าย 90° จนด้านหน้าหันมาทางคุณ</translation>
    </message>
    <message>
        <source>Turn it by 90° to the right, until its front looks at you</source>
        <translation>หมุนไปทางขวา 90° จนด้านหน้าหันมาทางคุณ</translation>
    </message>
    <message>
        <source>Turn to the left</source>
        <translation>หมุนซ้าย</translation>
    </message>
    <message>
        <source>Turn to the right</source>
        <translation>หมุนขวา</translation>
    </message>
    <message>
        <source>Keep the pictures of the file</source>
        <translation>เก็บรูปภาพในไฟล์ไว้</translation>
    </message>
    <message>
        <source>Without, parts have a plain colour, and the home is smaller</source>
        <translation>ถ้าไม่เก็บ ส่วนต่าง ๆ จะเป็นสีเรียบ และไฟล์บ้านจะเล็กลง</translation>
    </message>
    <message>
        <source>Drag to look at it from all sides</source>
        <translation>ลากเพื่อดูรอบด้าน</translation>
    </message>
    <message>
        <source>Drag turns it, the wheel comes nearer</source>
        <translation>ลากเพื่อหมุน ล้อเมาส์เพื่อเข้าใกล้</translation>
    </message>
</context>
<context>
    <name>idap::NewRoomDialog</name>
    <message>
        <source>New room</source>
        <translation>ห้องใหม่</translation>
    </message>
</context>
<context>
    <name>idap::NewRoomForm</name>
    <message>
        <source>Width &amp;X</source>
        <translation>กว้าง &amp;X</translation>
    </message>
    <message>
        <source>Depth &amp;Y</source>
        <translation>ลึก &amp;Y</translation>
    </message>
    <message>
        <source>Height &amp;Z</source>
        <translation>สูง &amp;Z</translation>
    </message>
    <message>
        <source>The clear size between the walls. Takes units and sums: 4.2m, 13&apos;6&quot;, 320+45.</source>
        <translation>ขนาดภายในระหว่างผนัง ใส่หน่วยและผลบวกได้: 4.2m, 13&apos;6&quot;, 320+45</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>เริ่ม(&amp;S)</translation>
    </message>
    <message>
        <source>Makes a room of this size with four walls, ready to be furnished</source>
        <translation>สร้างห้องขนาดนี้พร้อมผนังสี่ด้าน จัดเฟอร์นิเจอร์ได้ทันที</translation>
    </message>
</context>
<context>
    <name>idap::NumberField</name>
    <message>
        <source>“%1” is not a number. Write a number or a sum: 45, 2.5, 30+15.</source>
        <translation>“%1” ไม่ใช่ตัวเลข พิมพ์ตัวเลขหรือผลบวก: 45, 2.5, 30+15</translation>
    </message>
    <message>
        <source>This must be a whole number.</source>
        <translation>ต้องเป็นจำนวนเต็ม</translation>
    </message>
</context>
<context>
    <name>idap::OwnFurnitureDialog</name>
    <message>
        <source>My furniture</source>
        <translation>เฟอร์นิเจอร์ของฉัน</translation>
    </message>
    <message>
        <source>Can be resized</source>
        <translation>ปรับขนาดได้</translation>
    </message>
    <message>
        <source>Keeps its proportions</source>
        <translation>คงสัดส่วน</translation>
    </message>
    <message>
        <source>Being made…</source>
        <translation>กำลังสร้าง…</translation>
    </message>
    <message>
        <source>&amp;Name (English)</source>
        <translation>ชื่อ (อังกฤษ)(&amp;N)</translation>
    </message>
    <message>
        <source>Name (&amp;Thai)</source>
        <translation>ชื่อ (ไทย)(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Category</source>
        <translation>หมวดหมู่(&amp;C)</translation>
    </message>
    <message>
        <source>Category (Thai)</source>
        <translation>หมวดหมู่ (ไทย)</translation>
    </message>
    <message>
        <source>Ta&amp;gs</source>
        <translation>แท็ก(&amp;G)</translation>
    </message>
    <message>
        <source>Words to find it by, with commas</source>
        <translation>คำค้นหา คั่นด้วยจุลภาค</translation>
    </message>
    <message>
        <source>&amp;Price (%1)</source>
        <translation>ราคา (%1)(&amp;P)</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>ความกว้าง</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>ความลึก</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>ความสูง</translation>
    </message>
    <message>
        <source>to</source>
        <translation>ถึง</translation>
    </message>
    <message>
        <source>Not smaller than this; empty: any size</source>
        <translation>ไม่เล็กกว่านี้ ว่างไว้: ทุกขนาด</translation>
    </message>
    <message>
        <source>Not larger than this; empty: any size</source>
        <translation>ไม่ใหญ่กว่านี้ ว่างไว้: ทุกขนาด</translation>
    </message>
    <message>
        <source>%1 from</source>
        <translation>%1 จาก</translation>
    </message>
    <message>
        <source>Making furniture of the selection</source>
        <translation>กำลังสร้างเฟอร์นิเจอร์จากสิ่งที่เลือก</translation>
    </message>
    <message>
        <source>Materials: %1</source>
        <translation>วัสดุ: %1</translation>
    </message>
    <message>
        <source>The price is not a number.</source>
        <translation>ราคาไม่ใช่ตัวเลข</translation>
    </message>
    <message>
        <source>The smallest size is larger than the largest.</source>
        <translation>ขนาดเล็กสุดใหญ่กว่าขนาดใหญ่สุด</translation>
    </message>
    <message>
        <source>Save as furniture</source>
        <translation>บันทึกเป็นเฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>Change furniture</source>
        <translation>แก้ไขเฟอร์นิเจอร์</translation>
    </message>
    <message>
        <source>C&amp;reator</source>
        <translation>ผู้สร้าง(&amp;R)</translation>
    </message>
</context>
<context>
    <name>idap::PartFinishes</name>
    <message>
        <source>Part %1</source>
        <translation>ส่วนที่ %1</translation>
    </message>
    <message>
        <source>Picture of the file</source>
        <translation>รูปภาพในไฟล์</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>ตามในไฟล์</translation>
    </message>
    <message>
        <source>Material, colour or picture of this part.</source>
        <translation>วัสดุ สี หรือรูปภาพของส่วนนี้</translation>
    </message>
</context>
<context>
    <name>idap::PictureForm</name>
    <message>
        <source>Own size</source>
        <translation>ขนาดกำหนดเอง</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>ร่าง</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>ดี</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>ดีที่สุด</translation>
    </message>
    <message>
        <source>By time</source>
        <translation>ตามเวลา</translation>
    </message>
    <message>
        <source>Ray-traced light</source>
        <translation>แสงจากการติดตามรังสี</translation>
    </message>
    <message>
        <source>Classic, as in 1993</source>
        <translation>คลาสสิกแบบปี 1993</translation>
    </message>
    <message>
        <source>As in the home</source>
        <translation>ตามในบ้าน</translation>
    </message>
    <message>
        <source>All on</source>
        <translation>เปิดทั้งหมด</translation>
    </message>
    <message>
        <source>All off</source>
        <translation>ปิดทั้งหมด</translation>
    </message>
    <message>
        <source>Every point of view that is ticked becomes a picture</source>
        <translation>ทุกมุมกล้องที่ทำเครื่องหมายจะกลายเป็นภาพ</translation>
    </message>
    <message>
        <source>Points of view</source>
        <translation>มุมกล้อง</translation>
    </message>
    <message>
        <source>Upright or across</source>
        <translation>แนวตั้งหรือแนวนอน</translation>
    </message>
    <message>
        <source>Day and hour of these pictures, at the home&apos;s place; otherwise the point of view&apos;s</source>
        <translation>วันและเวลาของภาพเหล่านี้ ณ ที่ตั้งบ้าน มิฉะนั้นใช้ของมุมกล้อง</translation>
    </message>
    <message>
        <source>The live view, as it is now</source>
        <translation>มุมมองสดตามที่เป็นอยู่ตอนนี้</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>จากด้านบน</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>กล้อง %1</translation>
    </message>
    <message>
        <source>Live view</source>
        <translation>มุมมองสด</translation>
    </message>
    <message>
        <source>Tick at least one point of view.</source>
        <translation>ทำเครื่องหมายมุมกล้องอย่างน้อยหนึ่งมุม</translation>
    </message>
    <message>
        <source>At another &amp;time</source>
        <translation>ในเวลาอื่น(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Ray Trace %1 pictures</source>
        <translation>เรนเดอร์ %1 ภาพ(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Ray Trace</source>
        <translation>เรนเดอร์(&amp;R)</translation>
    </message>
    <message>
        <source>Ray-traced, like film</source>
        <translation>ลำแสง แบบฟิล์ม</translation>
    </message>
    <message>
        <source>Brightness as colour</source>
        <translation>ความสว่างเป็นสี</translation>
    </message>
    <message>
        <source>Softer contrast; bright lights turn white</source>
        <translation>คอนทราสต์นุ่มลง แสงจ้ากลายเป็นสีขาว</translation>
    </message>
    <message>
        <source>Blue is dark, green a middle grey, red as bright as the screen can show</source>
        <translation>น้ำเงินคือมืด เขียวคือเทากลาง แดงคือสว่างเท่าที่จอแสดงได้</translation>
    </message>
    <message>
        <source>All is sharp</source>
        <translation>คมชัดทั้งภาพ</translation>
    </message>
    <message>
        <source>A little blur, f/8</source>
        <translation>เบลอเล็กน้อย f/8</translation>
    </message>
    <message>
        <source>Some blur, f/2.8</source>
        <translation>เบลอปานกลาง f/2.8</translation>
    </message>
    <message>
        <source>Much blur, f/1.4</source>
        <translation>เบลอมาก f/1.4</translation>
    </message>
    <message>
        <source>What is in the middle of the picture is sharp; what is nearer or farther is blurred</source>
        <translation>สิ่งที่อยู่กลางภาพคมชัด สิ่งที่ใกล้หรือไกลกว่าจะเบลอ</translation>
    </message>
    <message>
        <source>In stops, as on a camera: each makes the picture twice as bright</source>
        <translation>เป็นสต็อปเหมือนกล้อง แต่ละสต็อปทำให้ภาพสว่างขึ้นเท่าตัว</translation>
    </message>
    <message>
        <source>Keep &amp;vertical lines vertical</source>
        <translation>ให้เส้นตั้งตรงเสมอ(&amp;V)</translation>
    </message>
    <message>
        <source>As with an architect&apos;s shift lens: walls do not lean when the view looks up or down</source>
        <translation>เหมือนเลนส์ชิฟต์ของสถาปนิก ผนังไม่เอียงเมื่อมองขึ้นหรือลง</translation>
    </message>
</context>
<context>
    <name>idap::PicturePanel</name>
    <message>
        <source>Where the picture is seen from: above, or a camera of the home</source>
        <translation>มองจากที่ใด: จากด้านบน หรือจากกล้องในบ้าน</translation>
    </message>
    <message>
        <source>Ray Trace: make a picture of the home as it is now</source>
        <translation>เรนเดอร์: สร้างภาพบ้านตามสภาพปัจจุบัน</translation>
    </message>
    <message>
        <source>Stop tracing and keep the picture as it is</source>
        <translation>หยุดเรนเดอร์และเก็บภาพที่ได้ไว้</translation>
    </message>
    <message>
        <source>Save the picture as a PNG or JPEG file</source>
        <translation>บันทึกภาพเป็นไฟล์ PNG หรือ JPEG</translation>
    </message>
    <message>
        <source>Give this view the whole window, and back (double click)</source>
        <translation>ขยายมุมมองนี้เต็มหน้าต่าง หรือกลับเหมือนเดิม (ดับเบิลคลิก)</translation>
    </message>
    <message>
        <source>No picture yet</source>
        <translation>ยังไม่มีภาพ</translation>
    </message>
    <message>
        <source>Ray Trace shows your home in its real light, from above or from a camera.</source>
        <translation>เรนเดอร์แสดงบ้านในแสงจริง จากด้านบนหรือจากกล้อง</translation>
    </message>
    <message>
        <source>Ray Trace</source>
        <translation>เรนเดอร์</translation>
    </message>
    <message>
        <source>Picture of an earlier state: Ray Trace again</source>
        <translation>ภาพก่อนการแก้ไข: เรนเดอร์ใหม่</translation>
    </message>
    <message>
        <source>The home has changed since this picture was begun</source>
        <translation>บ้านเปลี่ยนไปแล้วตั้งแต่เริ่มสร้างภาพนี้</translation>
    </message>
    <message>
        <source>How far the picture is: it becomes finer until then</source>
        <translation>ความคืบหน้าของภาพ ภาพจะละเอียดขึ้นเรื่อย ๆ</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>จากด้านบน</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>กล้อง %1</translation>
    </message>
    <message>
        <source>Preparing…</source>
        <translation>กำลังเตรียม…</translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>เหลือ %1 วินาที</translation>
    </message>
    <message>
        <source>Saving the picture</source>
        <translation>กำลังบันทึกภาพ</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>ภาพ</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>บันทึกภาพ</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>ภาพ PNG (*.png)</translation>
    </message>
    <message>
        <source>JPEG picture (*.jpg *.jpeg)</source>
        <translation>ภาพ JPEG (*.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>The time of the picture&apos;s daylight: %1, %2</source>
        <translation>เวลาของแสงธรรมชาติในภาพ: %1 %2</translation>
    </message>
    <message>
        <source>Back to the live view</source>
        <translation>กลับไปมุมมองสด</translation>
    </message>
    <message>
        <source>Where the live view stands</source>
        <translation>ตำแหน่งของมุมมองสด</translation>
    </message>
</context>
<context>
    <name>idap::PictureQueue</name>
    <message>
        <source>Keeping the picture</source>
        <translation>กำลังเก็บภาพ</translation>
    </message>
</context>
<context>
    <name>idap::PictureWindow</name>
    <message>
        <source>Now</source>
        <translation>ตอนนี้</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>รูปภาพ</translation>
    </message>
    <message>
        <source>Gallery of the home</source>
        <translation>แกลเลอรีของบ้าน</translation>
    </message>
    <message>
        <source>Makes this picture again, of the home as it is now, and compares the two</source>
        <translation>สร้างภาพนี้อีกครั้งจากบ้านในตอนนี้ และเปรียบเทียบทั้งสองภาพ</translation>
    </message>
    <message>
        <source>Lays another picture beside this one, with a divider to drag</source>
        <translation>วางอีกภาพข้างภาพนี้โดยมีเส้นแบ่งให้ลาก</translation>
    </message>
    <message>
        <source>As PNG, JPEG, PCX or GIF; as OpenEXR while the program runs in which it was made</source>
        <translation>เป็น PNG, JPEG, PCX หรือ GIF และเป็น OpenEXR ได้ขณะที่โปรแกรมที่สร้างภาพยังเปิดอยู่</translation>
    </message>
    <message>
        <source>Into the clipboard</source>
        <translation>ไปยังคลิปบอร์ด</translation>
    </message>
    <message>
        <source>Gives this picture another name (F2)</source>
        <translation>ตั้งชื่อใหม่ให้ภาพนี้ (F2)</translation>
    </message>
    <message>
        <source>Takes this picture out of the gallery; can be undone</source>
        <translation>นำภาพนี้ออกจากแกลเลอรี เลิกทำได้</translation>
    </message>
    <message>
        <source>%1, before</source>
        <translation>%1 ก่อนหน้า</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>บันทึกภาพ</translation>
    </message>
    <message>
        <source>%1 should end in .png, .jpg, .pcx, .gif or .exr</source>
        <translation>%1 ควรลงท้ายด้วย .png, .jpg, .pcx, .gif หรือ .exr</translation>
    </message>
    <message>
        <source>an OpenEXR file needs the light it was made of; make the picture again first</source>
        <translation>ไฟล์ OpenEXR ต้องใช้แสงที่สร้างภาพ สร้างภาพอีกครั้งก่อน</translation>
    </message>
    <message>
        <source>Saving the picture</source>
        <translation>กำลังบันทึกภาพ</translation>
    </message>
    <message>
        <source>A&amp;gain</source>
        <translation>อีกครั้ง(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>เปรียบเทียบ(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>บันทึก(&amp;S)…</translation>
    </message>
    <message>
        <source>Cop&amp;y</source>
        <translation>คัดลอก(&amp;Y)</translation>
    </message>
    <message>
        <source>Rena&amp;me</source>
        <translation>เปลี่ยนชื่อ(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>ลบ(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>แสง(&amp;L)</translation>
    </message>
    <message>
        <source>Dims, recolours and switches the lights of this picture without making it again</source>
        <translation>หรี่ เปลี่ยนสี และเปิดปิดแสงของภาพนี้โดยไม่ต้องสร้างใหม่</translation>
    </message>
    <message>
        <source>%1, other light</source>
        <translation>%1 แสงแบบอื่น</translation>
    </message>
    <message>
        <source>Keeping the mix</source>
        <translation>กำลังเก็บภาพที่ผสมแสง</translation>
    </message>
</context>
<context>
    <name>idap::PlanCaption</name>
    <message>
        <source>Plan X-Y</source>
        <translation>แปลน X-Y</translation>
    </message>
    <message>
        <source>Front X-Z</source>
        <translation>ด้านหน้า X-Z</translation>
    </message>
    <message>
        <source>Side Y-Z</source>
        <translation>ด้านข้าง Y-Z</translation>
    </message>
    <message>
        <source>Seen from above. Double click to fill the window with it, or to go back.</source>
        <translation>มองจากด้านบน ดับเบิลคลิกเพื่อขยายเต็มหน้าต่างหรือกลับเหมือนเดิม</translation>
    </message>
    <message>
        <source>Seen from the front. Double click to fill the window with it, or to go back.</source>
        <translation>มองจากด้านหน้า ดับเบิลคลิกเพื่อขยายเต็มหน้าต่างหรือกลับเหมือนเดิม</translation>
    </message>
    <message>
        <source>Seen from the right. Double click to fill the window with it, or to go back.</source>
        <translation>มองจากด้านขวา ดับเบิลคลิกเพื่อขยายเต็มหน้าต่างหรือกลับเหมือนเดิม</translation>
    </message>
    <message>
        <source>Fill the window with this view, or go back</source>
        <translation>ขยายมุมมองนี้เต็มหน้าต่าง หรือกลับเหมือนเดิม</translation>
    </message>
</context>
<context>
    <name>idap::PreferencesDialog</name>
    <message>
        <source>Solid</source>
        <translation>ทึบ</translation>
    </message>
    <message>
        <source>Hatched upwards</source>
        <translation>แรเงาเฉียงขึ้น</translation>
    </message>
    <message>
        <source>Hatched downwards</source>
        <translation>แรเงาเฉียงลง</translation>
    </message>
    <message>
        <source>Cross-hatched</source>
        <translation>แรเงาตาราง</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>การตั้งค่า</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>ภาษา(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Unit of length</source>
        <translation>หน่วยความยาว(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>ธีม(&amp;T)</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>เมตร</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>เซนติเมตร</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>มิลลิเมตร</translation>
    </message>
    <message>
        <source>Feet and inches</source>
        <translation>ฟุตและนิ้ว</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>ตามเดสก์ท็อป</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>สว่าง</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>มืด</translation>
    </message>
    <message>
        <source>Lengths are shown in it; any unit can be typed</source>
        <translation>ใช้แสดงความยาว ส่วนการพิมพ์ใช้หน่วยใดก็ได้</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>การเขียนแบบ</translation>
    </message>
    <message>
        <source>&amp;Snap to ends, lines, walls and pieces</source>
        <translation>สแนปเข้าหาปลาย เส้น ผนัง และชิ้นต่าง ๆ(&amp;S)</translation>
    </message>
    <message>
        <source>The Alt key turns it off while it is held</source>
        <translation>กดปุ่ม Alt ค้างเพื่อพักไว้</translation>
    </message>
    <message>
        <source>Snap to the gr&amp;id</source>
        <translation>สแนปเข้ากริด(&amp;I)</translation>
    </message>
    <message>
        <source>Show the &amp;grid</source>
        <translation>แสดงกริด(&amp;G)</translation>
    </message>
    <message>
        <source>Show the &amp;rulers</source>
        <translation>แสดงไม้บรรทัด(&amp;R)</translation>
    </message>
    <message>
        <source>Show the level &amp;below faintly</source>
        <translation>แสดงชั้นที่ต่ำกว่าจาง ๆ(&amp;B)</translation>
    </message>
    <message>
        <source>Walls that &amp;close make a room</source>
        <translation>ผนังที่ล้อมครบกลายเป็นห้อง(&amp;C)</translation>
    </message>
    <message>
        <source>New walls</source>
        <translation>ผนังใหม่</translation>
    </message>
    <message>
        <source>Th&amp;ickness</source>
        <translation>ความหนา(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>ความสูง(&amp;H)</translation>
    </message>
    <message>
        <source>that of the home</source>
        <translation>ตามบ้าน</translation>
    </message>
    <message>
        <source>Empty: the height of the level, or of the home</source>
        <translation>ว่าง: ตามความสูงของชั้นหรือของบ้าน</translation>
    </message>
    <message>
        <source>&amp;Pattern</source>
        <translation>ลวดลาย(&amp;P)</translation>
    </message>
</context>
<context>
    <name>idap::PrintDialog</name>
    <message>
        <source>Print</source>
        <translation>พิมพ์</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>มาตราส่วน(&amp;S)</translation>
    </message>
    <message>
        <source>P&amp;aper</source>
        <translation>กระดาษ(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Orientation</source>
        <translation>การวางกระดาษ(&amp;O)</translation>
    </message>
    <message>
        <source>As large as fits</source>
        <translation>ใหญ่เท่าที่พอดี</translation>
    </message>
    <message>
        <source>&amp;Title, notes, scale and date</source>
        <translation>ชื่อเรื่อง บันทึก มาตราส่วน และวันที่(&amp;T)</translation>
    </message>
    <message>
        <source>Along the lower edge; title and notes are those of the Text command</source>
        <translation>ตามขอบล่าง ชื่อเรื่องและบันทึกมาจากคำสั่งข้อความ</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>พิมพ์(&amp;P)…</translation>
    </message>
    <message>
        <source>Save as P&amp;DF…</source>
        <translation>บันทึกเป็น P&amp;DF…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>ปิด</translation>
    </message>
    <message>
        <source>Save as PDF</source>
        <translation>บันทึกเป็น PDF</translation>
    </message>
    <message>
        <source>plan</source>
        <translation>แปลน</translation>
    </message>
    <message>
        <source>The PDF cannot be written.</source>
        <translation>เขียนไฟล์ PDF ไม่ได้</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>แนวตั้ง</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>แนวนอน</translation>
    </message>
    <message>
        <source>The page before</source>
        <translation>หน้าก่อน</translation>
    </message>
    <message>
        <source>The next page</source>
        <translation>หน้าถัดไป</translation>
    </message>
    <message>
        <source>Tick what to print.</source>
        <translation>ทำเครื่องหมายสิ่งที่จะพิมพ์</translation>
    </message>
    <message>
        <source>One page.</source>
        <translation>หนึ่งหน้า</translation>
    </message>
    <message>
        <source>%1 pages.</source>
        <translation>%1 หน้า</translation>
    </message>
    <message>
        <source>It is printed at %1.</source>
        <translation>พิมพ์ที่มาตราส่วน %1</translation>
    </message>
    <message>
        <source>S&amp;heets</source>
        <translation>แผ่น(&amp;H)</translation>
    </message>
    <message>
        <source>Plans of all &amp;levels</source>
        <translation>แปลนของทุกชั้น(&amp;L)</translation>
    </message>
    <message>
        <source>Save as S&amp;VG…</source>
        <translation>บันทึกเป็น SVG(&amp;V)…</translation>
    </message>
    <message>
        <source>Save as SVG</source>
        <translation>บันทึกเป็น SVG</translation>
    </message>
    <message>
        <source>The SVG cannot be written.</source>
        <translation>เขียนไฟล์ SVG ไม่ได้</translation>
    </message>
    <message>
        <source>There is nothing of that to print yet.</source>
        <translation>ยังไม่มีสิ่งนั้นให้พิมพ์</translation>
    </message>
</context>
<context>
    <name>idap::Recovery</name>
    <message>
        <source>Keeping a copy</source>
        <translation>กำลังเก็บสำเนา</translation>
    </message>
</context>
<context>
    <name>idap::Section</name>
    <message>
        <source>Several levels</source>
        <translation>หลายชั้น</translation>
    </message>
    <message>
        <source>Reading the parts of the model…</source>
        <translation>กำลังอ่านส่วนต่าง ๆ ของโมเดล…</translation>
    </message>
    <message>
        <source>The model cannot be read: %1</source>
        <translation>อ่านโมเดลไม่ได้: %1</translation>
    </message>
    <message>
        <source>As it comes</source>
        <translation>ตามเดิม</translation>
    </message>
    <message>
        <source>%1, tinted</source>
        <translation>%1, ย้อมสี</translation>
    </message>
    <message>
        <source>Material, colour or picture of this part.</source>
        <translation>วัสดุ สี หรือรูปภาพของส่วนนี้</translation>
    </message>
    <message>
        <source>Below the horizon</source>
        <translation>อยู่ใต้ขอบฟ้า</translation>
    </message>
    <message>
        <source>north</source>
        <translation>เหนือ</translation>
    </message>
    <message>
        <source>north-east</source>
        <translation>ตะวันออกเฉียงเหนือ</translation>
    </message>
    <message>
        <source>east</source>
        <translation>ตะวันออก</translation>
    </message>
    <message>
        <source>south-east</source>
        <translation>ตะวันออกเฉียงใต้</translation>
    </message>
    <message>
        <source>south</source>
        <translation>ใต้</translation>
    </message>
    <message>
        <source>south-west</source>
        <translation>ตะวันตกเฉียงใต้</translation>
    </message>
    <message>
        <source>west</source>
        <translation>ตะวันตก</translation>
    </message>
    <message>
        <source>north-west</source>
        <translation>ตะวันตกเฉียงเหนือ</translation>
    </message>
    <message>
        <source>%1 high in the %2</source>
        <translation>สูง %1 ทางทิศ%2</translation>
    </message>
    <message>
        <source>In no wall</source>
        <translation>ไม่อยู่ในผนัง</translation>
    </message>
    <message>
        <source>%1 long, %2 thick</source>
        <translation>ยาว %1 หนา %2</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 ถึง %2</translation>
    </message>
    <message>
        <source>Several values</source>
        <translation>หลายค่า</translation>
    </message>
</context>
<context>
    <name>idap::SiteDialog</name>
    <message>
        <source>Compass and place</source>
        <translation>เข็มทิศและสถานที่</translation>
    </message>
    <message>
        <source>&amp;Town</source>
        <translation>เมือง(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Latitude</source>
        <translation>ละติจูด(&amp;L)</translation>
    </message>
    <message>
        <source>L&amp;ongitude</source>
        <translation>ลองจิจูด(&amp;O)</translation>
    </message>
    <message>
        <source>Time &amp;zone</source>
        <translation>เขตเวลา(&amp;Z)</translation>
    </message>
    <message>
        <source>&amp;Date and hour</source>
        <translation>วันและเวลา(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;North</source>
        <translation>ทิศเหนือ(&amp;N)</translation>
    </message>
    <message>
        <source>Show the &amp;compass on the plan</source>
        <translation>แสดงเข็มทิศบนแปลน(&amp;C)</translation>
    </message>
    <message>
        <source>Sets place and time zone; type to find it</source>
        <translation>กำหนดสถานที่และเขตเวลา พิมพ์เพื่อค้นหา</translation>
    </message>
    <message>
        <source>North of the equator positive</source>
        <translation>เหนือเส้นศูนย์สูตรเป็นค่าบวก</translation>
    </message>
    <message>
        <source>East of Greenwich positive</source>
        <translation>ตะวันออกของกรีนิชเป็นค่าบวก</translation>
    </message>
    <message>
        <source>The home&apos;s own time: where the sun stands in its pictures</source>
        <translation>เวลาของบ้าน: กำหนดตำแหน่งดวงอาทิตย์ในภาพ</translation>
    </message>
    <message>
        <source>Clockwise from up the page; the rose can be turned by hand</source>
        <translation>ตามเข็มนาฬิกาจากด้านบนของหน้า หมุนเข็มทิศด้วยเมาส์ได้</translation>
    </message>
    <message>
        <source>(another place)</source>
        <translation>(ที่อื่น)</translation>
    </message>
</context>
<context>
    <name>idap::TextArea</name>
    <message>
        <source>Several values</source>
        <translation>หลายค่า</translation>
    </message>
</context>
<context>
    <name>idap::TextDialog</name>
    <message>
        <source>Title and notes</source>
        <translation>ชื่อเรื่องและบันทึก</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>ชื่อเรื่อง(&amp;T)</translation>
    </message>
    <message>
        <source>Na&amp;me of the home</source>
        <translation>ชื่อบ้าน(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Notes</source>
        <translation>บันทึก(&amp;N)</translation>
    </message>
    <message>
        <source>Printed above the plan</source>
        <translation>พิมพ์ไว้เหนือแปลน</translation>
    </message>
    <message>
        <source>Anything worth remembering about this home; kept in its file</source>
        <translation>สิ่งที่ควรจำเกี่ยวกับบ้านนี้ เก็บไว้ในไฟล์บ้าน</translation>
    </message>
</context>
<context>
    <name>idap::TextField</name>
    <message>
        <source>Several values</source>
        <translation>หลายค่า</translation>
    </message>
</context>
<context>
    <name>idap::ValueField</name>
    <message>
        <source>Several values</source>
        <translation>หลายค่า</translation>
    </message>
    <message>
        <source>This must be at least %1.</source>
        <translation>ต้องไม่น้อยกว่า %1</translation>
    </message>
    <message>
        <source>This must be at most %1.</source>
        <translation>ต้องไม่เกิน %1</translation>
    </message>
</context>
<context>
    <name>idap::View3d</name>
    <message>
        <source>Preparing the view…</source>
        <translation>กำลังเตรียมมุมมอง…</translation>
    </message>
</context>
<context>
    <name>idap::WelcomePage</name>
    <message>
        <source>Starts a new home like this one</source>
        <translation>เริ่มบ้านใหม่จากแบบนี้</translation>
    </message>
    <message>
        <source>Draw a home, furnish it, and see it as it would really look. Nothing can go wrong: everything can be undone.</source>
        <translation>เขียนแบบบ้าน จัดเฟอร์นิเจอร์ แล้วดูภาพเสมือนจริง ไม่ต้องกลัวผิด เลิกทำได้ทุกอย่าง</translation>
    </message>
    <message>
        <source>New room</source>
        <translation>ห้องใหม่</translation>
    </message>
    <message>
        <source>Start from a template</source>
        <translation>เริ่มจากแม่แบบ</translation>
    </message>
    <message>
        <source>Recent homes</source>
        <translation>บ้านล่าสุด</translation>
    </message>
    <message>
        <source>Homes you open or save appear here.</source>
        <translation>บ้านที่เปิดหรือบันทึกจะแสดงที่นี่</translation>
    </message>
    <message>
        <source>&amp;Open a home…</source>
        <translation>เปิดบ้าน(&amp;O)…</translation>
    </message>
    <message>
        <source>Reads a home of IDAP (.idap) or Sweet Home 3D (.sh3d)</source>
        <translation>อ่านบ้านของ IDAP (.idap) หรือ Sweet Home 3D (.sh3d)</translation>
    </message>
</context>
</TS>
